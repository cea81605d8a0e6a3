// All that is known of every pixel of a frame, as channels of an EXR file.
#pragma once

#include <filesystem>

#include "app/display/Display.h"
#include "app/frames/Drawings.h"
#include "app/output/ChannelFile.h"
#include "datasets/maps/ExrFile.h"
#include "datasets/session/file/SessionInExr.h"

namespace umbra {

// The first frame that is added gives R, G, B, u, v, receiver and reference. Each frame gives
// TECHNIQUE.R, .G, .B, .visibility and .error, which is 0 where a pixel receives no shadow. Colours
// are linear, as EXR viewers expect.
class FrameLayers {
 public:
  explicit FrameLayers(const Session& session) : file_(session) {}

  // The frame as `technique` last rendered it.
  void add(const Technique& technique, HeadlessFrame& frame);
  // What the file shows as a whole, where that is more than the session.
  void setWorkspace(const Workspace& workspace) {
    file_.note(workspaceAttribute, sessionText(workspace));
  }
  void write(const std::filesystem::path& file) const { file_.write(file); }

 private:
  ChannelFile file_;
  bool first_ = true;
};

// The frame of a pane as it was last rendered, as a part of a file: R, G, B, u, v, receiver,
// reference, visibility and error. Its attributes are the pane's own.
ExrPart partOf(const Drawing& pane, HeadlessFrame& frame);

// visibility − reference where a pixel receives shadow, else 0.
Image<float> errorOf(const SurfaceImage& surfaces, const Image<float>& reference);

}  // namespace umbra

// A technique's error on the surfaces of a rendered scene.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "analysis/surfaces/SurfaceErrors.h"
#include "app/display/Display.h"

namespace umbra {

// The options of `compare --surfaces`.
struct SurfaceOptions {
  std::string extension = "vtp";  // the files' extension without a dot: vtp or ply
  SurfaceMeshSettings mesh;
};

// These throw BadCommandLine for another format, or an edge out of range.
std::string surfaceFormatFrom(const std::string& name, std::string_view where);
double surfaceEdgeFrom(const std::string& text, std::string_view where);

// Measures techniques on the surfaces of one scene, which are divided once for all techniques.
class SurfaceCompare {
 public:
  // Against ray-traced visibility, or exact percentage-closer filtering.
  SurfaceCompare(const FrameSettings& settings, const SurfaceOptions& options, bool rayTraced);

  // Errors with the map of the frame that was last rendered, and with its technique. Works on every
  // core; can be interrupted.
  SurfaceErrors errors(HeadlessFrame& frame);
  // "bleeding-vsm.vtp" for the drawing of the name "vsm".
  std::string fileName(const std::string& name) const;
  void write(const FieldMesh& mesh, const std::filesystem::path& file, Display& display) const;

 private:
  const SurfaceMesh& meshOn(const FrameSnapshot& frame);

  SurfaceOptions options_;
  bool rayTraced_;
  std::unique_ptr<RayTracedVisibility> rays_;  // through the one map
  std::optional<SurfaceMesh> mesh_;
};

}  // namespace umbra

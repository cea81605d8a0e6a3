// What a source names, read or built: for the window and the command line alike.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/session/Session.h"
#include "filters/core/maps/Image.h"
#include "filters/core/support/Progress.h"

namespace umbra {

// Either a scene or a depth map. Shared and never changed, so that an undo step costs nothing.
struct Content {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const DepthMap> depth;
  // Whose map `depth` is: where its texels lie in the file's count, and what its depths measure.
  std::shared_ptr<const DepthFile> depthFile;
  // One line for people for each thing that was left out on the way, such as faces without area.
  std::vector<std::string> notices;

  bool operator==(const Content&) const = default;
};

// What a texel of a depth map is called: its coordinates in the file's own count. Those of a
// scene's map are its own.
Pixel texelInFile(const Content& content, const Pixel& texel);

// Throws BadInput for what cannot be read, is not in the catalogue or has no triangle to draw. Safe
// on any thread. Who hears the progress of a mesh file may stop it by an exception.
Content loadSource(const SceneSource& source, const Progress& progress = {});
// A depth-file source, alone: a large one is not kept twice. Throws BadInput.
DepthFile loadDepth(const SceneSource& source);

}  // namespace umbra

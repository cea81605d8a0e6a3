// From the name that a person gives to the scene or depth map that it stands for.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/session/LoadSource.h"
#include "datasets/session/Session.h"

namespace umbra {

// A catalogue scene or an existing mesh file. Throws BadCommandLine for a name that is neither,
// with the nearest scene, and BadInput for a mesh file that is not there.
SceneSource sceneSourceFrom(const std::string& name, std::string_view where);

// "PARAMETER=VALUE" of a catalogue scene; throws BadCommandLine.
void adjustScene(SceneSource& source, const std::string& setting);

// Scenes of catalogue and mesh sources. Each is built or read once, with one warning in the log for
// what a mesh file lost.
class SceneLoader {
 public:
  // Throws BadInput, and BadCommandLine for a depth map, which has no scene.
  std::shared_ptr<const Scene> scene(const SceneSource& source);

 private:
  std::vector<std::pair<SceneSource, std::shared_ptr<const Scene>>> loaded_;
};

// A depth-file source, with a warning in the log for what was doubtful. Throws BadInput.
DepthFile loadedDepth(const SceneSource& source);
// The receiver's linear depth for the texel at (x, y), counted from the map's corner. Throws
// BadCommandLine for what is no depth, or lies beyond the planes.
double receiverFrom(std::string_view text, std::string_view option, const DepthFile& file, int x,
                    int y);

// For tables and files: the scene's name, or a file's name without its folder.
std::string shortNameOf(const SceneSource& source);

}  // namespace umbra

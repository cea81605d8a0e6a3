// From the name that a person gives to the scene or depth map that it stands for.
#pragma once

#include <string>
#include <string_view>

#include "datasets/session/LoadSource.h"
#include "datasets/session/Session.h"

namespace umbra {

// A catalogue scene or an existing mesh file. Throws BadCommandLine for a name that is neither,
// with the nearest scene, and BadInput for a mesh file that is not there.
SceneSource sceneSourceFrom(const std::string& name, std::string_view where);

// "PARAMETER=VALUE" of a catalogue scene; throws BadCommandLine.
void adjustScene(SceneSource& source, const std::string& setting);

// The scene of a catalogue or mesh source, with a warning in the log for what a mesh file lost.
// Throws BadInput, and BadCommandLine for a depth map, which has no scene.
Scene loadScene(const SceneSource& source);

// For tables and files: the scene's name, or a file's name without its folder.
std::string shortNameOf(const SceneSource& source);

}  // namespace umbra

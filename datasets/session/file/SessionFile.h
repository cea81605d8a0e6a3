// Workspaces as JSON, which people call sessions: for files, for the window's memory and inside
// exported EXR files, of which each part has the session that it shows. Light, camera, frame and
// size are read and written by the tables of settings (SessionSettings.h); an example:
//
// {"format": "umbrascope-session/1",
//  "source": {"scene": "tree-bench", "parameters": {"a": 0.1}}
//            | {"mesh": "fan.ply"} | {"depth": "m.exr", "channel": "Z", "range": [0, 1]},
//  "light":  {"kind": "spot", "position": [x,y,z], "target": [x,y,z], "halfAngle": 30,
//             "colour": [r,g,b], "intensity": 1},
//  "camera": {"position": [x,y,z], "target": [x,y,z], "up": [x,y,z], "viewAngle": 30},
//  "frame":  {"mapSize": 1024, "format": "float", "filter": "bilinear", "anisotropy": 8,
//             "sat": {"size": "footprint", "precision": "centred", "distance": 0}, "msaa": 1,
//             "cascades": {"count": 1, "splitLambda": 0.5, "seam": 0.1, "frozen": a camera},
//             "view": "shaded", "errorRange": 1,
//             "kernel": {"shape": "box", "radius": 3, "sigma": 0},
//             "bias": {"constant": 5e-4, "slope": 1, "receiverPlane": true,
//                      "cullFrontFaces": false}},
//  "technique": "vsm",
//  "parameters": {"vsm": {"min-variance": 1e-5}, "lvsm": {"splits": [0.2, 0.5]}},
//  "compare": {"mode": "grid", "techniques": ["vsm", "lvsm"]
//              | "panes": [{"technique": "vsm"},
//                          {"technique": "vsm", "active": true, "kernel": {"radius": 12},
//                           "parameters": {"bleed-reduction": 0.3}}], "wipe": 0.5},
//  "size": [1280, 720], "probe": [x, y], "receiver": 0.7,
//  "probes": [{"name": "bench", "point": [x,y,z] | "texel": [x, y], "receiver": 0.7}],
//  "keptProbe": "bench"}
//
// Every key but "format" may be absent and then has its default; "light" and "camera" absent means
// the scene's own, "frozen" absent that the cascades follow the camera.
// A saved session has "compare" once something was compared, "probes" once one was saved, and
// "keptProbe" while "probe" is at one of them. A pane may have of its own what "parameters" has for
// its technique and what "frame" has, but "view"; "parameters" and "frame" are what panes share.
// One pane is active: the first of the session's technique where none says so.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "datasets/session/Workspace.h"
#include "datasets/session/file/SessionFileParameters.h"

namespace umbra {

inline constexpr const char* sessionFormat = "umbrascope-session/1";

nlohmann::ordered_json toJson(const Workspace& workspace);
// `where` is what errors begin with, the file's name. Throws BadInput for an unknown key, a wrong
// type, a value out of range, an unknown technique or parameter, a light or camera without picture,
// parameters that contradict each other: each names its key.
Workspace workspaceFrom(const nlohmann::ordered_json& json, std::string_view where);

std::string toText(const Workspace& workspace);  // indented
Workspace workspaceFromText(std::string_view text, std::string_view where);

// Reads JSON, or the session in an OpenEXR file that this program wrote. Paths of meshes and depth
// maps in the file are relative to its folder.
Workspace readWorkspace(const std::filesystem::path& file);
void writeWorkspace(const Workspace& workspace, const std::filesystem::path& file);

}  // namespace umbra

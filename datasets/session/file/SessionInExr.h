// Sessions inside the OpenEXR files that this program writes, so that a file brings back what it
// was made of.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "datasets/session/Workspace.h"

namespace umbra {

// Attributes of such a file: the session that a part shows, and what the whole file shows where
// that is more than one part's: several techniques, or panes.
inline constexpr const char* sessionAttribute = "umbrascope.session";
inline constexpr const char* workspaceAttribute = "umbrascope.workspace";

// The attributes' text. Paths of meshes and depth maps in it are absolute.
std::string sessionText(const Workspace& workspace);

// What a file says of the program and of what it was made of, by attribute.
std::map<std::string, std::string> sessionAttributes(const Workspace& workspace,
                                                     const std::string& version);

// The text of the file's session; nothing where it has none or is no OpenEXR file.
std::optional<std::string> sessionInExr(const std::filesystem::path& file);

}  // namespace umbra

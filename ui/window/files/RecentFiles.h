// The files that were opened last, kept from one start to the next.
#pragma once

#include <filesystem>
#include <vector>

namespace umbra {

// The latest first, at most ten; files that are gone by now are among them. Of a depth map with the
// channel that was asked for: "maps/d.exr:Z".
std::vector<std::filesystem::path> recentFiles();
// Puts the file before all others.
void rememberFile(const std::filesystem::path& file);
void forgetRecentFiles();

}  // namespace umbra

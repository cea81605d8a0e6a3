// The one way in which a file from outside is opened: whatever its path names, it cannot hang the
// program, take memory without end or end it with an exception of the library.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace umbra {

// Bytes that a session or a lesson may have; those that people write have some thousands.
inline constexpr std::uintmax_t largestJson = 16u << 20;
// Bytes that a mesh may have: about fifty million triangles.
inline constexpr std::uintmax_t largestMesh = 8ull << 30;

// The file's size in bytes. Throws BadInput that names the file: there is none, it is a folder, a
// pipe or a device, it cannot be read, or it has more than `most` bytes.
std::uintmax_t checkInput(const std::filesystem::path& file, std::uintmax_t most = UINTMAX_MAX);

// The whole content. Throws as checkInput does.
std::string contentOf(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace umbra

// Single files out of a ZIP archive.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace umbra {

// The contents of `entries` in their order. Throws BadInput that names the archive and the entry
// that is missing, damaged or larger than 256 MB.
std::vector<std::string> readArchive(const std::filesystem::path& archive,
                                     const std::vector<std::string>& entries);

}  // namespace umbra

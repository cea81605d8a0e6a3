// What must be known of an OpenEXR file before the library reads it.
#pragma once

#include <filesystem>

namespace umbra {

// OpenEXR allocates what an attribute of the header promises before it looks whether the file has
// it: 65 bytes could ask for 2 GiB. Throws BadInput that names the file and the attribute where one
// promises more bytes than the file has, and where the file is none that can be opened. What is
// otherwise no OpenEXR file is left to the library to refuse.
void checkExrAttributes(const std::filesystem::path& file);

}  // namespace umbra

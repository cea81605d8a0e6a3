// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/display/Display.h"

namespace umbra {

// One picture as it is; several side by side, at most four in a row, each under its label. Needs a
// QApplication for several. Throws BadOutput; nothing half-written.
void writePng(const std::vector<LabelledPicture>& pictures, const std::filesystem::path& file);

// One picture as it is.
std::string pngOf(const Image<std::uint8_t>& picture);

}  // namespace umbra

// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/display/Display.h"

namespace umbra {

// Writes one picture as it is, or several side by side, at most four in a row, each under its
// label; several need a QApplication. Throws BadOutput and then leaves no file half written.
void writePng(const std::vector<LabelledPicture>& pictures, const std::filesystem::path& file);

// One picture as it is.
std::string pngOf(const Image<std::uint8_t>& picture);

}  // namespace umbra

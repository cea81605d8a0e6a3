// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/display/Display.h"

namespace umbra {

// Writes one picture as it is, or several in rows and columns that come near a screen's shape, each
// under its label; several need a QApplication. `texts` are kept in the file beside the pictures.
// Throws BadOutput and then leaves no file half written.
void writePng(const std::vector<LabelledPicture>& pictures, const std::filesystem::path& file,
              const PictureTexts& texts);

// One picture as it is.
std::string pngOf(const Image<std::uint8_t>& picture);

}  // namespace umbra

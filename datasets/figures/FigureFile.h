// Figures as files: see Figure.h.
#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/figures/Figure.h"

namespace umbra {

inline constexpr const char* figureFormat = "umbrascope-figure/1";

// Throws BadInput that begins with `where` and names the key. `folder` is what paths in the figure
// are relative to.
Figure figureFromText(std::string_view text, std::string_view where,
                      const std::filesystem::path& folder);
Figure readFigure(const std::filesystem::path& file);

}  // namespace umbra

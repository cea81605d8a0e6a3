// The texts of datasets/figures/*.json, as they were when the program was built.
#pragma once

#include <string_view>
#include <vector>

namespace umbra {

struct EmbeddedFigure {
  std::string_view name;  // the file's name
  std::string_view text;
};

std::vector<EmbeddedFigure> embeddedFigures();

}  // namespace umbra

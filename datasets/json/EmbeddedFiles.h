// Files of datasets as they were when the program was built.
#pragma once

#include <string_view>
#include <vector>

namespace umbra {

struct EmbeddedFile {
  std::string_view name;  // without its folder
  std::string_view text;
};

// Those of datasets/lessons/*.json and of datasets/figures/*.json, in the order of their names;
// those of lessons begin with a number.
std::vector<EmbeddedFile> embeddedLessons();
std::vector<EmbeddedFile> embeddedFigures();

}  // namespace umbra

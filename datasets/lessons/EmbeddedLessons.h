// The texts of datasets/lessons/*.json, as they were when the program was built.
#pragma once

#include <string_view>
#include <vector>

namespace umbra {

struct EmbeddedLesson {
  std::string_view name;  // of the file
  std::string_view text;
};

// In the order of the files' names, which begin with a number.
std::vector<EmbeddedLesson> embeddedLessons();

}  // namespace umbra

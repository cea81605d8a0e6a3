// The texts of datasets/lessons/*.json, as they were when the program was built.
#pragma once

#include <string_view>
#include <vector>

namespace umbra {

struct EmbeddedLesson {
  std::string_view name;  // the file's name
  std::string_view text;
};

// The order is that of the files' names, which begin with a number.
std::vector<EmbeddedLesson> embeddedLessons();

}  // namespace umbra

// The lessons that the program brings: the files of datasets/lessons.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "datasets/lessons/Lesson.h"

namespace umbra {

// All lessons, in teaching order.
std::vector<Lesson> lessonCatalogue();

// The lesson of this name in the catalogue or, where `name` ends in ".json", a teacher's own file.
// Throws BadInput for an unknown name, with the nearest one, and as readLesson does.
Lesson lessonNamed(const std::string& name);

}  // namespace umbra

// The lessons that the program brings: the files of datasets/lessons.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "datasets/lessons/Lesson.h"

namespace umbra {

// In teaching order.
std::vector<Lesson> lessonCatalogue();

// One of the catalogue, or, where `name` ends in ".json", a teacher's own file. Throws BadInput for
// a name that there is not, with the nearest one, and as readLesson does.
Lesson lessonNamed(const std::string& name);

}  // namespace umbra

// A lesson as one page of HTML that needs nothing beside itself: to print, to mail, to put on a
// course's site.
#pragma once

#include <string>
#include <vector>

#include "app/lessons/LessonSteps.h"

namespace umbra {

// `results` as LessonMeasurer gives them. Pictures are data URIs, plots are drawn in SVG; answers
// are folded away.
std::string lessonPage(Display& display, const Lesson& lesson,
                       const std::vector<StepResult>& results);

// For a terminal, without what is measured.
std::string lessonText(const Lesson& lesson);

}  // namespace umbra

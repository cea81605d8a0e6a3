// Numbers in a lesson's texts, which are computed when a text is shown, so that none is ever typed:
// "{{variance}}", "{{error evsm4}}", "{{receiver - mean}}". A name is a quantity of the step's
// probe; a technique may follow it, and is the step's own where none does.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/lessons/Lesson.h"

namespace umbra {

// A quantity's value, where it is known.
using LessonValues = std::function<std::optional<double>(const LessonQuantity&)>;

// The quantities that the text has numbers of, for a step (index) of that technique. Throws
// BadInput that begins with `where` for a number that cannot be computed.
std::vector<LessonQuantity> quantitiesIn(std::string_view text, const std::string& technique,
                                         std::size_t step, std::string_view where);

// The text with its numbers, to three digits; "…" stands for one that is not known.
std::string filled(std::string_view text, const LessonStep& step, std::size_t index,
                   const LessonValues& values);

// "0.0453", "−0.37", "1.2·10⁻⁶".
std::string lessonNumber(double value);

}  // namespace umbra

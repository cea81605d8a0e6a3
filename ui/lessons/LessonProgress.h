// How far a reader is in a lesson: a plain value.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "datasets/lessons/Lesson.h"

namespace umbra {

struct LessonProgress {
  Lesson lesson;                            // has at least one step
  std::size_t step = 0;                     // index
  std::map<std::size_t, double> predicted;  // by step; what was predicted stays predicted

  const LessonStep& current() const { return lesson.steps[step]; }
  bool atFirst() const { return step == 0; }
  bool atLast() const { return step + 1 == lesson.steps.size(); }
  std::optional<double> prediction() const {
    const auto found = predicted.find(step);
    return found == predicted.end() ? std::nullopt : std::optional(found->second);
  }
  // The step asks for a prediction that has not been given: its values stay hidden.
  bool veiled() const { return current().question && !prediction(); }
};

}  // namespace umbra

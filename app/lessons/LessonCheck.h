// Whether what a lesson claims holds, in windows of several shapes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/lessons/LessonSteps.h"
#include "app/output/Output.h"

namespace umbra {

// What a claim comes to in a picture of each shape. That a question has the same answer in every
// shape is a claim, too.
struct CheckedClaim {
  std::size_t step = 0;                   // index
  std::string text, quantity, relation;   // "visibility of vsm", "≈"
  std::optional<double> within;           // of ≈: the largest difference
  std::vector<ClaimResult> results = {};  // in the order of lessonShapes

  bool holds() const;
};

// In the order of the steps; what a step asks comes before what it claims.
std::vector<CheckedClaim> checkLesson(LessonMeasurer& measurer, const Lesson& lesson);

// {"name", "steps": [{"step", "claims": [{"text", "quantity", "relation", "measured", "expected",
// "within", "shape", "holds"}]}]}, a claim for each shape.
Json claimsToJson(const Lesson& lesson, const std::vector<CheckedClaim>& claims);
// A table with a row for each claim and a column for each shape.
std::string claimsText(const std::vector<CheckedClaim>& claims);

// "1280x720".
std::string nameOf(const PictureShape& shape);

}  // namespace umbra

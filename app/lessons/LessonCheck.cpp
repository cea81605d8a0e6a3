#include "app/lessons/LessonCheck.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/output/Table.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using ByShape = std::vector<std::vector<StepResult>>;  // by step, in the order of lessonShapes

// An answer may come out otherwise by half of what a prediction may be off, so that a prediction
// which is right in one window is right, or nearly so, in every other.
CheckedClaim sameAnswer(const LessonQuestion& question, std::size_t step, const ByShape& shapes) {
  CheckedClaim claim{step, "The answer is the same in every window", describe(question.asked), "≈",
                     question.tolerance / 2.0};
  const double first = valueOf(shapes.front(), question.asked);
  for (const std::vector<StepResult>& results : shapes) {
    const double answer = valueOf(results, question.asked);
    claim.results.push_back({answer, first, std::abs(answer - first) <= *claim.within});
  }
  return claim;
}

CheckedClaim checked(const LessonClaim& claim, std::size_t step, const ByShape& shapes) {
  CheckedClaim result{step, claim.text, describe(claim.left), nameOf(claim.relation), {}};
  if (claim.relation == Relation::Near) result.within = claim.tolerance;
  for (const std::vector<StepResult>& results : shapes)
    result.results.push_back(checkClaim(results, claim));
  return result;
}

// "0.216 ± 0.004"; by shape where what is expected depends on it: "0.1307 0.1611 …".
std::string expectedText(const CheckedClaim& claim) {
  std::vector<std::string> texts;
  for (const ClaimResult& result : claim.results) texts.push_back(shortNumber(result.right));
  const bool same = std::all_of(texts.begin(), texts.end(),
                                [&](const std::string& text) { return text == texts.front(); });
  const std::string text = same ? texts.front() : joined(texts, " ");
  return claim.within ? text + " ± " + shortNumber(*claim.within) : text;
}

}  // namespace

bool CheckedClaim::holds() const {
  return std::all_of(results.begin(), results.end(),
                     [](const ClaimResult& result) { return result.holds; });
}

std::vector<CheckedClaim> checkLesson(LessonMeasurer& measurer, const Lesson& lesson) {
  ByShape shapes;
  for (const PictureShape& shape : lessonShapes) shapes.push_back(measurer.steps(lesson, shape));
  std::vector<CheckedClaim> claims;
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    if (const auto& question = lesson.steps[step].question)
      claims.push_back(sameAnswer(*question, step, shapes));
    for (const LessonClaim& claim : lesson.steps[step].claims)
      claims.push_back(checked(claim, step, shapes));
  }
  return claims;
}

Json claimsToJson(const Lesson& lesson, const std::vector<CheckedClaim>& claims) {
  Json steps = Json::array();
  for (std::size_t step = 0; step < lesson.steps.size(); ++step)
    steps.push_back({{"step", step + 1}, {"claims", Json::array()}});
  for (const CheckedClaim& claim : claims)
    for (std::size_t i = 0; i < claim.results.size(); ++i)
      steps[claim.step]["claims"].push_back(
          {{"text", claim.text},
           {"quantity", claim.quantity},
           {"relation", claim.relation},
           {"measured", claim.results[i].left},
           {"expected", claim.results[i].right},
           {"within", claim.within ? Json(*claim.within) : Json()},
           {"shape", nameOf(lessonShapes[i])},
           {"holds", claim.results[i].holds}});
  return {{"name", lesson.name}, {"steps", std::move(steps)}};
}

std::string claimsText(const std::vector<CheckedClaim>& claims) {
  TableRow heading{"STEP", "QUANTITY"};
  for (const PictureShape& shape : lessonShapes) heading.push_back(nameOf(shape));
  for (const char* column : {"", "EXPECTED", "HOLDS", "CLAIM"}) heading.push_back(column);
  std::vector<TableRow> rows{heading};
  for (const CheckedClaim& claim : claims) {
    TableRow row{std::to_string(claim.step + 1), claim.quantity};
    for (const ClaimResult& result : claim.results) row.push_back(shortNumber(result.left));
    row.insert(row.end(),
               {claim.relation, expectedText(claim), claim.holds() ? "yes" : "no", claim.text});
    rows.push_back(std::move(row));
  }
  return tableText(rows);
}

std::string nameOf(const PictureShape& shape) {
  return std::to_string(shape.width) + "x" + std::to_string(shape.height);
}

}  // namespace umbra

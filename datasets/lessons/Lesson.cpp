#include "datasets/lessons/Lesson.h"

#include <algorithm>
#include <cmath>

#include "datasets/lessons/LessonNumbers.h"

namespace umbra {

bool holds(const LessonClaim& claim, double left, double right) {
  switch (claim.relation) {
    case Relation::Less:
      return left < right;
    case Relation::Greater:
      return left > right;
    case Relation::Near:
      break;
  }
  return std::abs(left - right) <= claim.tolerance;
}

std::string describe(const LessonQuantity& quantity) {
  const QuantityInfo& info = infoOf(quantity.quantity);
  return std::string(info.name) + (info.ofTechnique ? " of " + quantity.technique : std::string());
}

std::vector<std::string> textsOf(const LessonStep& step) {
  std::vector<std::string> texts{step.text, step.look};
  if (step.question) texts.insert(texts.end(), {step.question->text, step.question->explanation});
  return texts;
}

std::vector<std::string> techniquesOf(const Lesson& lesson, std::size_t step) {
  std::vector<std::string> ids{lesson.steps[step].session.technique};
  const auto add = [&](const LessonQuantity& quantity) {
    if (quantity.step != step || !infoOf(quantity.quantity).ofTechnique) return;
    if (std::find(ids.begin(), ids.end(), quantity.technique) == ids.end())
      ids.push_back(quantity.technique);
  };
  for (const std::string& text : textsOf(lesson.steps[step]))
    for (const LessonQuantity& quantity :
         quantitiesIn(text, lesson.steps[step].session.technique, step, ""))
      add(quantity);
  for (const LessonStep& one : lesson.steps) {
    if (one.question) add(one.question->asked);
    for (const LessonClaim& claim : one.claims) {
      add(claim.left);
      if (claim.right) add(*claim.right);
    }
  }
  return ids;
}

}  // namespace umbra

// A lesson: steps to read and look at, each with its own session, questions that are answered by
// prediction, and claims that can be computed.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "datasets/json/Relation.h"
#include "datasets/session/Workspace.h"
#include "filters/core/support/Quantity.h"

namespace umbra {

// What a step's point is called among the saved probes.
inline constexpr const char* lessonProbe = "lesson";

// A quantity of a step's probe or frame.
struct LessonQuantity {
  Quantity quantity = Quantity::Visibility;
  std::string technique;  // the session's technique where the file names none
  std::size_t step = 0;   // index; files count from 1, and leave it out for the step itself

  bool operator==(const LessonQuantity&) const = default;
};

// The claim that `left` stands in `relation` to `right`, or to `value`.
struct LessonClaim {
  std::string text;  // "Nothing of the light should arrive here"
  LessonQuantity left;
  Relation relation = Relation::Near;
  std::optional<LessonQuantity> right;
  double value = 0.0;      // used where `right` is absent
  double tolerance = 0.0;  // Near: the largest difference
};

// A question whose answer the reader predicts before the program shows it.
struct LessonQuestion {
  std::string text;            // Markdown
  LessonQuantity asked;        // a quantity of this step's probe
  double low = 0.0, high = 1;  // the range of a prediction, low < high
  double tolerance = 0.0;      // a prediction that is off by at most this is right
  std::string explanation;     // Markdown: why it comes out as it does
};

struct LessonStep {
  std::string title;
  std::string text;             // Markdown: paragraphs, lists, formulas indented by four spaces
  std::string look;             // Markdown: what to look at
  Eigen::Vector3d at{0, 0, 0};  // world: the point of a surface that the step is about
  Workspace workspace;          // what the window opens: its saved probe is held at the point
  Session session;              // what its active pane shows: a scene
  std::optional<LessonQuestion> question;
  std::vector<LessonClaim> claims;
};

struct Lesson {
  std::string name;     // "light-bleeding", kebab-case
  std::string title;    // "Light bleeding"
  std::string summary;  // one sentence
  std::string after;    // "Lauritzen 2008, §3.3"
  std::vector<LessonStep> steps;
};

// Whether `left` and `right` (or the claim's `value`, where it has no `right`) are as the claim
// says.
bool holds(const LessonClaim& claim, double left, double right);
// "visibility of vsm": for tables and failures.
std::string describe(const LessonQuantity& quantity);
// The texts of the step that may have numbers: see LessonNumbers.h.
std::vector<std::string> textsOf(const LessonStep& step);
// The techniques that the step mentions, each once; the session's own is first.
std::vector<std::string> techniquesOf(const Lesson& lesson, std::size_t step);

}  // namespace umbra

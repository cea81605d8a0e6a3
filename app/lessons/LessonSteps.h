// A lesson's steps rendered and measured, without a window.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/errors/Metrics.h"
#include "app/display/Display.h"
#include "app/frames/SceneProbe.h"
#include "datasets/lessons/Lesson.h"

namespace umbra {

struct StepResult {
  SceneProbe probe;                        // of every technique that the lesson measures there
  std::map<std::string, Metrics> metrics;  // by id, of those whose whole frame is measured
  Image<std::uint8_t> picture;             // as the session asks for it
};

struct ClaimResult {
  double left = 0.0, right = 0.0;
  bool holds = false;
};

// In the order of the lesson's steps. Throws BadInput that names lesson and step for a probe that
// hits no surface and for a technique that the step's format cannot hold.
std::vector<StepResult> measureSteps(Display& display, const Lesson& lesson);

double valueOf(const std::vector<StepResult>& results, const LessonQuantity& quantity);
ClaimResult checkClaim(const std::vector<StepResult>& results, const LessonClaim& claim);

}  // namespace umbra

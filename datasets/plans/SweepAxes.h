// The axes of a sweep, and the cells that they span: see SweepPlan.h.
#pragma once

#include "datasets/plans/SweepPlan.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

// Reads "axes", "combine" and "skip". Fills `plan.settings` and `plan.cells`. Throws BadInput.
void readSweepAxes(JsonObject& object, SweepPlan& plan);

}  // namespace umbra

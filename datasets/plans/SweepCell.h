// One cell of a sweep as a session.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "datasets/plans/SweepPlan.h"

namespace umbra {

// Gives the scene of a source that is not a depth map.
using SceneOf = std::function<std::shared_ptr<const Scene>(const SceneSource&)>;

// The base with what the cell sets. Settings of light and camera need the scene, whose own they
// start from; without `sceneOf` they are only checked. Throws BadInput that names the plan, the
// cell's place and the setting.
Session sessionOfCell(const SweepPlan& plan, std::size_t cell, const TechniqueCatalogue& catalogue,
                      const SceneOf& sceneOf, const std::string& where);

// A value as tables have it: "vsm", "0.5", "on".
std::string textOfValue(const SweepValue& value);

}  // namespace umbra

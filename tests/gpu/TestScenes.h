// Small scenes whose shadows are known.
#pragma once

#include <memory>

#include "filters/core/scene/Scene.h"

namespace umbra::test {

// A rectangle with corner and edges in world coordinates; its normal is edgeA × edgeB.
Mesh rectangle(const Eigen::Vector3f& corner, const Eigen::Vector3f& edgeA,
               const Eigen::Vector3f& edgeB);
// A closed box between two corners.
Mesh box(const Eigen::Vector3f& low, const Eigen::Vector3f& high);

// A ground of 10 × 10 in the plane y = 0, and over it a slab off the centre: x in [1, 3],
// z in [−2, −1], y in [1, 1.2]. The light shines straight down, the camera looks from the front.
std::shared_ptr<Scene> slabOverGround();

// The same with a slanting light and a ball of facets beside the slab.
std::shared_ptr<Scene> slabAndBall();

// A long ground with three rows of posts, seen from one end at a man's height.
std::shared_ptr<Scene> avenue();

}  // namespace umbra::test

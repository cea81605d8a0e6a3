// A broad-leaved tree.
#pragma once

#include "datasets/scenes/MeshBuilder.h"

namespace umbra::scenes {

struct TreeShape {
  double height = 4.2;  // height of the crown's top
  double crown = 1.7;   // horizontal radius of the crown
  double trunk = 0.13;  // radius at the foot
  int leaves = 5000;
  double leafLength = 0.24;
  std::uint64_t seed = 1;
};

struct Tree {
  Mesh wood, leaves;
};

// The tree's foot stands on the origin.
Tree growTree(const TreeShape& shape);

}  // namespace umbra::scenes

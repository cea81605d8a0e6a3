// Vertices that lie at one place.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace umbra {

// For each position the index of the first one that equals it; +0 and −0 are equal.
std::vector<std::uint32_t> firstOfEqual(const std::vector<Eigen::Vector3f>& positions);

}  // namespace umbra

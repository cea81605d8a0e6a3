// The choices that nothing else beats.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace umbra {

// Less is better of both.
struct CostAndError {
  double cost = 0.0, error = 0.0;
};

// Places of the choices beside which no other is at least as good in both and better in one, by
// ascending cost. Of equal choices all are in the front.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> choices);

}  // namespace umbra

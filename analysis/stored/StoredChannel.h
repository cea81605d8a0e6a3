// A channel that an engine stored for a depth map, held against the exact one.
#pragma once

#include <cstddef>

#include "analysis/stored/StoredAssumption.h"

namespace umbra {

// The coarsest format that holds every finite value exactly, and is no finer than `declared`;
// `declared` itself where there are too few different values to tell.
StorageFormat formatThatHolds(const Image<double>& stored, const Channel& channel,
                              StorageFormat declared);

struct StoredDifference {
  std::size_t texels = 0;                      // that hold finite values, which alone are compared
  std::size_t notFinite = 0;                   // texels that hold none
  double largest = 0.0, mean = 0.0;            // of |stored - expected|
  double largestUnits = 0.0, meanUnits = 0.0;  // in the expectation's units
  int x = 0, y = 0;                            // where it is largest in these
  double expected = 0.0, stored = 0.0;         // there
  // Texels that differ by more than rounding allows, and those of them that lie farther than the
  // kernel's reach from the map's edge.
  std::size_t beyond = 0, beyondInside = 0;

  bool isRounding() const { return beyond == 0 && notFinite == 0; }
};

// Compares two images of one channel and of one size.
StoredDifference storedDifference(const StoredExpectation& expected, const Image<double>& stored,
                                  int reach);

}  // namespace umbra

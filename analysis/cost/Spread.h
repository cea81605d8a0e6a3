// What repeated measurements of one thing say about it.
#pragma once

#include <cstddef>
#include <span>

namespace umbra {

// The quartiles of measurements, in their unit.
struct Spread {
  double q1 = 0.0, median = 0.0, q3 = 0.0;
  std::size_t count = 0;  // measurements
};

// Between two measurements, quartiles are interpolated linearly: quantile p lies at place
// p (count − 1) of the ascending values, counted from 0. The spread of nothing is all 0.
Spread spreadOf(std::span<const double> values);

// Half the width of an interval that holds the true median with about 95 %:
// 1.57 (q3 − q1) / √count (McGill, Tukey and Larsen 1978, eq. 2). 0 without measurements.
double medianError(const Spread& spread);

// Whether more measurements would hardly move the median: its error is at most this part of it.
bool isSettled(const Spread& spread, double part);

}  // namespace umbra

// How much float arithmetic on the GPU may differ from the reference in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/core/maps/Region.h"
#include "filters/core/technique/Technique.h"

namespace umbra::test {

inline const double eps = unitRoundoff(StorageFormat::Float);

// How far visibility moves when every input is off by `roundings` float roundings: the GPU's
// result must be the exact one for inputs within that distance (mixed stability), up to as many
// roundings of its own. The technique declares how many its formula has. A normalised format's
// channel is low + span · stored, rounded in terms of its range. `reading` counts the roundings of
// the read that gave the channels; values of both signs are rounded in terms of their range too.
inline double visibilityError(const Technique& technique, StorageFormat format, const Fetch& fetch,
                              double receiver, int reading = 0) {
  const double roundings = technique.info().roundings + reading;
  const double exact = technique.visibility(fetch, receiver);
  double error = roundings * eps * technique.info().amplification;
  std::vector<double> channels(fetch.channels.begin(), fetch.channels.end());
  const auto worst = [&](auto&& evaluate) {
    error += std::max(std::abs(evaluate(roundings * eps) - exact),
                      std::abs(evaluate(-roundings * eps) - exact));
  };
  const std::vector<Channel> layout = technique.channels();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    double& channel = channels[c];
    const double value = channel;
    const bool bothSigns = reading > 0 && layout[c].low < 0.0 && layout[c].high > 0.0;
    const double size = isNormalised(format) || bothSigns
                            ? std::max(std::abs(layout[c].low), std::abs(layout[c].high))
                            : std::abs(value);
    worst([&](double relative) {
      channel = value + size * relative;
      return technique.visibility({channels, fetch.region}, receiver);
    });
    channel = value;
  }
  worst([&](double shift) { return technique.visibility(fetch, receiver + shift); });
  return error;
}

// How far `evaluate` moves when position and footprint are off by a few float roundings: the GPU
// multiplies, scales and adds them, and takes the length and logarithm of the latter.
template <class Evaluate>
double readError(const Evaluate& evaluate, const ReadPoint& read) {
  const double exact = evaluate(read);
  double error = 0.0;
  for (double du : {-4 * eps, 4 * eps}) {
    for (double dv : {-4 * eps, 4 * eps}) {
      ReadPoint moved = read;
      moved.u += du;
      moved.v += dv;
      error = std::max(error, std::abs(evaluate(moved) - exact));
    }
  }
  for (double part : {-8 * eps, 8 * eps}) {
    ReadPoint scaled = read;
    scaled.footprint.x *= 1.0 + part;
    scaled.footprint.y *= 1.0 + part;
    error = std::max(error, std::abs(evaluate(scaled) - exact));
  }
  return 2 * error;
}

// The largest sum of the weights of a summed-area box's rectangles along one axis: at most three,
// each of one whole texel's weight, but for a texel at the map's edge that repeats. `centre` and
// `width` in texels of a map of `size`.
inline double largestSatWeight(double centre, double width, int size) {
  const bool repeats = centre - width / 2 < 1.0 || centre + width / 2 > size - 1.0;
  return repeats ? 1.0 + 2.0 / width : 3.0 / width;
}

}  // namespace umbra::test

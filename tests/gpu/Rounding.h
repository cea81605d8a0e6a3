// How much float arithmetic on the GPU may differ from the reference in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "filters/core/maps/Region.h"
#include "filters/core/technique/Technique.h"

namespace umbra::test {

inline const double eps = unitRoundoff(StorageFormat::Float);

// How far the GPU's visibility may be from the reference's.
//
// The GPU's result must be the exact one for inputs that are off by a few float roundings, up to as
// many roundings of its own (mixed stability). The technique declares how many its formula has. The
// inputs are the channels, the receiver and the parameters, which reach a shader as floats.
class VisibilityBound {
 public:
  VisibilityBound(const Technique& technique, StorageFormat format)
      : technique_(technique), format_(format), layout_(technique.channels()) {
    const std::unique_ptr<Technique> copy = technique.clone();
    for (std::size_t i = 0; i < copy->parameters().size(); ++i) {
      const ParameterValue value = copy->parameters()[i].get();
      if (!std::holds_alternative<double>(value)) continue;
      // Moments are rounded again once they were moved by it towards a half.
      if (copy->parameters()[i].name == "moment-bias") least_ = 0.5 * std::get<double>(value);
      for (double relative : {-eps, eps}) {
        rounded_.push_back(technique.clone());
        rounded_.back()->parameters()[i].put(std::get<double>(value) * (1.0 + relative));
      }
    }
  }

  // `reading` counts the roundings of the read that gave the channels; values of both signs are
  // then rounded in terms of their range. `more` is by how much each channel may be off beside.
  double operator()(const Fetch& fetch, double receiver, int reading = 0,
                    std::span<const double> more = {}) const {
    const double roundings = technique_.info().roundings + reading;
    std::vector<double> off(fetch.channels.size());
    for (std::size_t c = 0; c < off.size(); ++c)
      off[c] = roundings * eps * sizeOf(layout_[c], fetch.channels[c], reading > 0) +
               (more.empty() ? 0.0 : more[c]);
    return roundings * eps * technique_.amplification() +
           std::max(eachOff(fetch, receiver, off, roundings * eps),
                    togetherOff(fetch, receiver, off, roundings * eps)) +
           roundedOff(fetch, receiver);
  }

 private:
  // The sum of what each input does by itself, to first order what all can do.
  double eachOff(const Fetch& fetch, double receiver, std::span<const double> off,
                 double shift) const {
    const double exact = technique_.visibility(fetch, receiver);
    std::vector<double> channels(fetch.channels.begin(), fetch.channels.end());
    const auto moved = [&](double at) {
      return std::abs(technique_.visibility({channels, fetch.region}, at) - exact);
    };
    double error = std::max(moved(receiver - shift), moved(receiver + shift));
    for (std::size_t c = 0; c < channels.size(); ++c) {
      double worst = 0.0;
      for (double sign : {-1.0, 1.0}) {
        channels[c] = fetch.channels[c] + sign * off[c];
        worst = std::max(worst, moved(receiver));
      }
      channels[c] = fetch.channels[c];
      error += worst;
    }
    return error;
  }

  // All inputs off at once, each by all or half of what it may be, or of a smaller share of that: a
  // variance of nearly nothing is lost only where the mean of squares is low and the mean itself is
  // not as low, and a bound of nearly singular moments swings to and fro.
  double togetherOff(const Fetch& fetch, double receiver, std::span<const double> off,
                     double shift) const {
    const double exact = technique_.visibility(fetch, receiver);
    constexpr double parts[] = {-1.0, -0.5, 0.5, 1.0};
    std::vector<double> channels(off.size());
    std::minstd_rand mixed;
    const auto part = [&] { return parts[mixed() >> 15 & 3]; };
    double worst = 0.0;
    for (int choice = 0; choice < 64; ++choice) {
      const double share = std::ldexp(1.0, -2 * (choice % 4));
      for (std::size_t c = 0; c < off.size(); ++c)
        channels[c] = fetch.channels[c] + share * part() * off[c];
      const double moved =
          technique_.visibility({channels, fetch.region}, receiver + share * part() * shift);
      worst = std::max(worst, std::abs(moved - exact));
    }
    return worst;
  }

  // What the parameters' own roundings do.
  double roundedOff(const Fetch& fetch, double receiver) const {
    const double exact = technique_.visibility(fetch, receiver);
    double error = 0.0;
    for (std::size_t i = 0; i < rounded_.size(); i += 2)
      error += std::max(std::abs(rounded_[i]->visibility(fetch, receiver) - exact),
                        std::abs(rounded_[i + 1]->visibility(fetch, receiver) - exact));
    return error;
  }

  // A normalised format's channel is low + span · stored, rounded in terms of its range.
  double sizeOf(const Channel& channel, double value, bool isRead) const {
    const bool bothSigns = isRead && channel.low < 0.0 && channel.high > 0.0;
    return isNormalised(format_) || bothSigns
               ? std::max(std::abs(channel.low), std::abs(channel.high))
               : std::max(std::abs(value), least_);
  }

  const Technique& technique_;
  StorageFormat format_;
  std::vector<Channel> layout_;
  double least_ = 0.0;  // in terms of which a channel is rounded at least
  std::vector<std::unique_ptr<Technique>> rounded_;  // two for each real parameter
};

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

#include "datasets/maps/DepthScale.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace umbra {

DepthScale::DepthScale(double atZero, double atOne, const DepthProjection& projection,
                       double farthest, const RasterInfo& info)
    : atZero_(atZero),
      atOne_(atOne),
      projection_(projection),
      near_(atZero),
      far_(atOne),
      width_(info.width),
      height_(info.height),
      number_(info.number) {
  if (projection.kind == DepthProjection::Kind::Linear) return;
  near_ = projection.near;
  far_ = projection.far > 0.0 ? projection.far : farthest;
}

double DepthScale::stretch(int x, int y) const {
  if (projection_.euclidAngle == 0.0) return 1.0;
  const double up = std::tan(0.5 * projection_.euclidAngle * std::numbers::pi / 180.0);
  const double right = up * double(width_) / double(height_);
  return std::hypot(1.0, right * ((2 * x + 1.0) / width_ - 1.0),
                    up * ((2 * y + 1.0) / height_ - 1.0));
}

double DepthScale::linearOfFile(double value, int x, int y) const {
  if (projection_.kind == DepthProjection::Kind::Linear)
    return (value - atZero_) / (atOne_ - atZero_);
  return linearOfWorld(worldOfFile(value, x, y));
}

double DepthScale::worldOfFile(double value, int x, int y) const {
  if (projection_.kind == DepthProjection::Kind::Linear) return value;
  return projection_.distance((value - atZero_) / (atOne_ - atZero_)) * stretch(x, y);
}

double DepthScale::linearOfWorld(double distance) const {
  return (distance - near_) / (far_ - near_);
}

double DepthScale::worldOf(double linear) const {
  return near_ + linear * (far_ - near_);
}

double DepthScale::fileOf(double linear, int x, int y) const {
  const bool isLinear = projection_.kind == DepthProjection::Kind::Linear;
  const double window = isLinear ? linear : projection_.window(worldOf(linear) / stretch(x, y));
  return atZero_ + window * (atOne_ - atZero_);
}

std::optional<GivenDepth> givenDepthFrom(std::string_view text) {
  GivenDepth given;
  if (text.ends_with('w')) given.measure = GivenDepth::Measure::World;
  if (text.ends_with('f')) given.measure = GivenDepth::Measure::File;
  if (given.measure != GivenDepth::Measure::Linear) text.remove_suffix(1);
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), given.value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(given.value))
    return std::nullopt;
  return given;
}

double linearOf(const GivenDepth& given, const DepthScale& scale, int x, int y) {
  switch (given.measure) {
    case GivenDepth::Measure::World:
      return scale.linearOfFile(scale.stored(scale.fileOf(scale.linearOfWorld(given.value), x, y)),
                                x, y);
    case GivenDepth::Measure::File:
      return scale.linearOfFile(scale.stored(given.value), x, y);
    case GivenDepth::Measure::Linear:
      break;
  }
  return given.value;
}

}  // namespace umbra

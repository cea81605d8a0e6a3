#include "datasets/maps/DepthConversion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"

namespace umbra {
namespace {

constexpr std::size_t namedTexels = 10;

std::string countOfTexels(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " texel" : " texels");
}

}  // namespace

void DepthConversion::begin(const RasterInfo& info) {
  info_ = info;
  // A bound is the number that the file can hold: 0.7 is the float nearest to it.
  import_.atZero = rounded(import_.atZero, info.number);
  import_.atOne = rounded(import_.atOne, info.number);
  if (import_.atZero == import_.atOne)
    throw Error(ErrorKind::BadInput, where_ + ": both ends of the depth range are " +
                                         toText(import_.atZero) + " as the file holds them");
  file_.map = DepthMap(info.width, info.height);
  file_.originX = info.originX;
  file_.originY = info.originY;
  file_.scale = DepthScale(import_.atZero, import_.atOne, import_.projection, 1.0, info);
  const double value = rounded(import_.miss.value, info.number);
  missIsMark_ = import_.miss.kind == DepthMiss::Kind::Value &&
                (!std::isfinite(value) || !isInside(value) || value == import_.nearValue());
}

bool DepthConversion::isInside(double value) const {
  return value >= std::min(import_.atZero, import_.atOne) &&
         value <= std::max(import_.atZero, import_.atOne);
}

double DepthConversion::read(double value, int x, int y) const {
  if (import_.projection.kind == DepthProjection::Kind::Linear)
    return file_.scale.linearOfFile(value, x, y);
  // A texel at the far bound saw nothing, wherever a far plane may be.
  if (value == import_.farValue()) return std::numeric_limits<double>::infinity();
  return file_.scale.worldOfFile(value, x, y);
}

double DepthConversion::replaced(double value, int x, int y) {
  // NaN is on neither side: it becomes the far bound.
  const double near = import_.nearValue(), far = import_.farValue();
  const bool toNear = (value - near) / (far - near) < 0.0;
  switch (import_.miss.kind) {
    case DepthMiss::Kind::Clamp:
      ++clamped_;
      return read(toNear ? near : far, x, y);
    case DepthMiss::Kind::Value:
      if (missIsMark_) break;
      ++marked_;
      return read(import_.miss.value, x, y);
    case DepthMiss::Kind::Error:
      break;
  }
  const int fileX = x + info_.originX, fileY = y + info_.originY;
  if (wrong_++ == 0) lowX_ = highX_ = fileX, lowY_ = highY_ = fileY;
  lowX_ = std::min(lowX_, fileX), highX_ = std::max(highX_, fileX);
  lowY_ = std::min(lowY_, fileY), highY_ = std::max(highY_, fileY);
  if (first_.size() < namedTexels) first_.push_back({fileX, fileY, value});
  return 1.0;
}

void DepthConversion::add(int y, std::span<const double> row) {
  const double mark = rounded(import_.miss.value, info_.number);
  const auto isMark = [&](double value) {
    return missIsMark_ && (value == mark || (std::isnan(value) && std::isnan(mark)));
  };
  for (int x = 0; x < info_.width; ++x) {
    const double value = row[std::size_t(x)];
    double& depth = file_.map(x, y);
    if (isMark(value)) {
      ++marked_;
      depth = read(import_.farValue(), x, y);
    } else {
      depth = isInside(value) ? read(value, x, y) : replaced(value, x, y);
    }
  }
}

// From distances to linear depths. Without a far plane the farthest texel that was hit is 1.
void DepthConversion::scaleDistances() {
  double farthest = 0.0;
  for (double distance : file_.map.values())
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  const double near = import_.projection.near;
  if (!(farthest > near)) farthest = 2.0 * near;  // a map that saw nothing, or the near plane alone
  file_.scale = DepthScale(import_.atZero, import_.atOne, import_.projection, farthest, info_);
  for (double& depth : file_.map.values()) {
    const double linear = std::isfinite(depth) ? file_.scale.linearOfWorld(depth) : 1.0;
    // Rounding alone makes depths of the planes differ from 0 and 1.
    beyond_ += linear > 1.0 + 1e-9;
    depth = std::clamp(linear, 0.0, 1.0);
  }
}

void DepthConversion::refuse() const {
  std::string texels;
  for (const Wrong& wrong : first_)
    texels += (texels.empty() ? "texel " : ", ") + std::to_string(wrong.x) + "," +
              std::to_string(wrong.y) + " is " + shortest(wrong.value, info_.number);
  if (wrong_ > first_.size()) texels += ", …";
  if (wrong_ > 1)
    texels = countOfTexels(wrong_) + " from " + std::to_string(lowX_) + "," +
             std::to_string(lowY_) + " to " + std::to_string(highX_) + "," +
             std::to_string(highY_) + " hold no depth: " + texels;
  throw Error(ErrorKind::BadInput, where_ + ": " + texels + "; depths are finite numbers from " +
                                       toText(import_.atZero) + " to " + toText(import_.atOne) +
                                       std::string(depthMissHint));
}

DepthFile DepthConversion::finish() {
  if (!info_.note.empty()) file_.notes.push_back(info_.note);
  if (wrong_ > 0) refuse();
  if (import_.projection.kind != DepthProjection::Kind::Linear) scaleDistances();
  if (clamped_ > 0)
    file_.notes.push_back(countOfTexels(clamped_) + " held no depth and became the nearest bound");
  if (marked_ > 0)
    file_.notes.push_back(
        countOfTexels(marked_) +
        (missIsMark_ ? " held " + shortest(import_.miss.value, info_.number) +
                           ", saw nothing and became the far bound"
                     : " held no depth and became " + shortest(import_.miss.value, info_.number)));
  if (beyond_ > 0)
    file_.notes.push_back(countOfTexels(beyond_) + " lie farther from the light than " +
                          toText(file_.scale.far()) + " and count as that far");
  if (import_.projection.isInfinite() && import_.projection.far == 0.0)
    file_.notes.push_back("the farthest texel, at " + toText(file_.scale.far()) +
                          ", has linear depth 1");
  return std::move(file_);
}

}  // namespace umbra

#include "datasets/maps/DepthProjection.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Kind = DepthProjection::Kind;

struct KindName {
  Kind kind;
  std::string_view name;
};

constexpr std::array<KindName, 5> kinds{{{Kind::Linear, "linear"},
                                         {Kind::Perspective, "perspective"},
                                         {Kind::Reversed, "reversed"},
                                         {Kind::Infinite, "infinite"},
                                         {Kind::ReversedInfinite, "reversed-infinite"}}};

std::optional<std::vector<double>> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : split(text, ',')) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

// What the words after the kind say; nothing where they are not right.
std::optional<DepthProjection> parsed(Kind kind, std::vector<std::string> words) {
  DepthProjection projection{.kind = kind};
  if (!words.empty() && words.back().starts_with("euclid,")) {
    const auto angle = numbersIn(words.back().substr(7));
    if (!angle || angle->size() != 1 || !((*angle)[0] > 0.0 && (*angle)[0] < 180.0))
      return std::nullopt;
    projection.euclidAngle = (*angle)[0];
    words.pop_back();
  }
  if (kind == Kind::Linear)
    return words.empty() && projection.euclidAngle == 0.0 ? std::optional(projection)
                                                          : std::nullopt;
  const bool infinite = projection.isInfinite();
  const auto first = words.empty() ? std::nullopt : numbersIn(words[0]);
  if (!first || first->size() != (infinite ? 1u : 2u)) return std::nullopt;
  projection.near = (*first)[0];
  if (!infinite) projection.far = (*first)[1];
  if (infinite && words.size() == 2) {
    const auto far = numbersIn(words[1]);
    if (!far || far->size() != 1) return std::nullopt;
    projection.far = (*far)[0];
    words.pop_back();
    if (!(projection.far > projection.near)) return std::nullopt;
  }
  const bool ordered = projection.near > 0.0 && (infinite || projection.far > projection.near);
  return words.size() == 1 && ordered ? std::optional(projection) : std::nullopt;
}

}  // namespace

double DepthProjection::distance(double w) const {
  const double none = std::numeric_limits<double>::infinity();
  switch (kind) {
    case Kind::Linear:
      return w;
    case Kind::Perspective:
      return near * far / (far - w * (far - near));
    case Kind::Reversed:
      return near * far / (near + w * (far - near));
    case Kind::Infinite:
      return w < 1.0 ? near / (1.0 - w) : none;
    case Kind::ReversedInfinite:
      return w > 0.0 ? near / w : none;
  }
  return w;
}

double DepthProjection::window(double z) const {
  switch (kind) {
    case Kind::Linear:
      return z;
    case Kind::Perspective:
      return far * (z - near) / (z * (far - near));
    case Kind::Reversed:
      return near * (far - z) / (z * (far - near));
    case Kind::Infinite:
      return 1.0 - near / z;
    case Kind::ReversedInfinite:
      return near / z;
  }
  return z;
}

DepthProjection projectionFrom(std::string_view text, std::string_view where) {
  std::vector<std::string> words = split(std::string(text), ':');
  for (const KindName& known : kinds) {
    if (words.empty() || words.front() != known.name) continue;
    words.erase(words.begin());
    if (const auto projection = parsed(known.kind, words)) return *projection;
    break;
  }
  throw Error(ErrorKind::BadInput, std::string(where) + ": '" + clipped(text) +
                                       "' is not right, it takes " + std::string(projectionSyntax) +
                                       ", with 0 < NEAR < FAR");
}

std::string toText(const DepthProjection& projection) {
  std::string text;
  for (const KindName& known : kinds)
    if (known.kind == projection.kind) text = known.name;
  if (projection.kind != Kind::Linear) text += ":" + toText(projection.near);
  if (projection.far > 0.0) text += (projection.isInfinite() ? ":" : ",") + toText(projection.far);
  if (projection.euclidAngle > 0.0) text += ":euclid," + toText(projection.euclidAngle);
  return text;
}

}  // namespace umbra

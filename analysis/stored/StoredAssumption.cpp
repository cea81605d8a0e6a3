#include "analysis/stored/StoredAssumption.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

std::string quantityText(const StoredAssumption& assumption, const StoredQuestion& question) {
  const std::vector<Channel> layout = question.technique.channels();
  switch (assumption.quantity) {
    case StoredQuantity::AfterFilter:
      return "The filtered depth is encoded, where the encoded depth should be filtered.";
    case StoredQuantity::Depth:
      return "The values are those of the filtered depth z itself.";
    case StoredQuantity::Reversed:
      return "The values are those of reversed depths, 1 - z.";
    case StoredQuantity::OtherChannel:
      return "The values are those of the channel " + layout[std::size_t(assumption.other)].name +
             ".";
    case StoredQuantity::Own:
      break;
  }
  return "";
}

std::string kernelText(const StoredAssumption& assumption, const Kernel& given) {
  if (assumption.kernel == given) return "";
  if (assumption.kernel.effectiveRadius() == 0) return "The values are not filtered.";
  return "The filter is a " + describe(assumption.kernel) +
         (given.effectiveRadius() == 0 ? ", where none should be."
                                       : ", not a " + describe(given) + ".");
}

std::string shiftText(const StoredAssumption& assumption) {
  if (assumption.shiftX == 0.0 && assumption.shiftY == 0.0) return "";
  return "The values lie shifted by " + shortNumber(assumption.shiftX) + "," +
         shortNumber(assumption.shiftY) + " texels (right, down).";
}

std::string scaleText(const StoredAssumption& assumption) {
  if (assumption.scale == 1.0 && assumption.offset == 0.0) return "";
  return "The values are " + shortNumber(assumption.scale) + " times what they should be" +
         (assumption.offset == 0.0 ? "." : ", plus " + shortNumber(assumption.offset) + ".");
}

// Half the distance of floats at 1, as a part of it.
constexpr double floatRounding = 0x1p-24;

// One channel's quantity over a map, or a part of it.
class Expecting {
 public:
  Expecting(const StoredAssumption& assumption, const StoredQuestion& question)
      : assumption_(assumption),
        technique_(question.technique),
        layout_(question.technique.channels()),
        channel_(assumption.quantity == StoredQuantity::OtherChannel ? assumption.other
                                                                     : question.channel) {}

  Image<double> values(const DepthMap& map) const {
    if (assumption_.quantity == StoredQuantity::Own ||
        assumption_.quantity == StoredQuantity::OtherChannel)
      return filtered(map, [&](double z) { return encoded(z); });
    if (assumption_.quantity == StoredQuantity::Reversed)
      return filtered(map, [&](double z) { return encoded(1.0 - z); });
    Image<double> depth = filtered(map, [](double z) { return z; });
    if (assumption_.quantity == StoredQuantity::AfterFilter)
      for (double& value : depth.values()) value = encoded(value);
    return depth;
  }

  Image<double> magnitude(const DepthMap& map) const {
    switch (assumption_.quantity) {
      case StoredQuantity::Own:
      case StoredQuantity::OtherChannel:
        return filtered(map, [&](double z) { return std::abs(encoded(z)); });
      case StoredQuantity::Reversed:
        return filtered(map, [&](double z) { return std::abs(encoded(1.0 - z)); });
      case StoredQuantity::Depth:
      case StoredQuantity::AfterFilter:
        break;
    }
    Image<double> image = values(map);
    for (double& value : image.values()) value = std::abs(value);
    return image;
  }

  // What one rounding of the encoded depth to float changes; where the filtered depth is encoded,
  // all roundings of the filter.
  Image<double> spread(const DepthMap& map) const {
    const auto change = [&](double z, double roundings) {
      return std::abs(encoded(z * (1.0 + roundings * floatRounding)) - encoded(z));
    };
    switch (assumption_.quantity) {
      case StoredQuantity::Own:
      case StoredQuantity::OtherChannel:
        return filtered(map, [&](double z) { return change(z, 1.0); });
      case StoredQuantity::Reversed:
        return filtered(map, [&](double z) { return change(1.0 - z, 1.0); });
      case StoredQuantity::Depth:
      case StoredQuantity::AfterFilter:
        break;
    }
    Image<double> depth = filtered(map, [](double z) { return z; });
    const double roundings = 2.0 * (2.0 * assumption_.kernel.effectiveRadius() + 3.0);
    for (double& value : depth.values())
      value = assumption_.quantity == StoredQuantity::Depth ? value * floatRounding
                                                            : change(value, roundings);
    return depth;
  }

 private:
  double encoded(double z) const {
    technique_.encode(z, all_);
    return all_[std::size_t(channel_)];
  }

  // The filter over what `quantity` makes of each depth.
  template <class Quantity>
  Image<double> filtered(const DepthMap& map, const Quantity& quantity) const {
    Channel reduced = layout_[std::size_t(channel_)];
    if (assumption_.quantity == StoredQuantity::Depth ||
        assumption_.quantity == StoredQuantity::AfterFilter)
      reduced.reduction = Reduction::Mean;
    Image<double> image(map.width(), map.height());
    for (std::size_t i = 0; i < image.values().size(); ++i)
      image.values()[i] = quantity(map.values()[i]);
    return reduceMap(image, std::span(&reduced, 1), assumption_.kernel);
  }

  const StoredAssumption& assumption_;
  const Technique& technique_;
  const std::vector<Channel> layout_;
  const int channel_;
  mutable std::vector<double> all_ = std::vector<double>(layout_.size());
};

}  // namespace

int changesOf(const StoredAssumption& assumption, const Kernel& given) {
  return int(assumption.quantity != StoredQuantity::Own) + int(!(assumption.kernel == given)) +
         int(assumption.rowsFromBelow) + int(assumption.shiftX != 0.0 || assumption.shiftY != 0.0) +
         int(assumption.scale != 1.0 || assumption.offset != 0.0);
}

std::string sentencesOf(const StoredAssumption& assumption, const StoredQuestion& question) {
  std::string all;
  for (const std::string& text :
       {quantityText(assumption, question), kernelText(assumption, question.kernel),
        std::string(assumption.rowsFromBelow ? "The rows run from below." : ""),
        shiftText(assumption), scaleText(assumption)})
    if (!text.empty()) all += (all.empty() ? "" : " ") + text;
  return all;
}

std::string_view nameOf(StoredQuantity quantity) {
  switch (quantity) {
    case StoredQuantity::Own:
      break;
    case StoredQuantity::AfterFilter:
      return "after-filter";
    case StoredQuantity::Depth:
      return "depth";
    case StoredQuantity::Reversed:
      return "reversed";
    case StoredQuantity::OtherChannel:
      return "other-channel";
  }
  return "own";
}

double lastPlaceOf(StorageFormat format, double value, const Channel& channel) {
  const auto spacing = [value](int smallestExponent, int digits) {
    const double magnitude = std::abs(value);
    const int exponent = magnitude > 0.0 ? std::ilogb(magnitude) : smallestExponent;
    return std::ldexp(1.0, std::max(exponent, smallestExponent) - digits);
  };
  switch (format) {
    case StorageFormat::Unorm8:
      return (channel.high - channel.low) / 255.0;
    case StorageFormat::Unorm16:
      return (channel.high - channel.low) / 65535.0;
    case StorageFormat::Half:
      return spacing(-14, 10);
    case StorageFormat::Float:
      return spacing(std::numeric_limits<float>::min_exponent - 1, 23);
    case StorageFormat::Double:
      break;
  }
  return spacing(std::numeric_limits<double>::min_exponent - 1, 52);
}

Image<double> valuesIn(const DepthMap& map, const StoredAssumption& assumption,
                       const StoredQuestion& question) {
  return Expecting(assumption, question).values(map);
}

StoredExpectation expectedIn(const DepthMap& map, const StoredAssumption& assumption,
                             const StoredQuestion& question) {
  const Expecting expecting(assumption, question);
  StoredExpectation expected{expecting.values(map), expecting.spread(map), {}};
  expected.allowance = expecting.magnitude(map);
  const Channel channel = question.technique.channels()[std::size_t(question.channel)];
  const double taps = 2.0 * assumption.kernel.effectiveRadius() + 1.0;
  const double timesStored = assumption.kernel.effectiveRadius() > 0 ? 3.0 : 1.0;
  for (std::size_t i = 0; i < expected.unit.values().size(); ++i) {
    double& unit = expected.unit.values()[i];
    double& allowance = expected.allowance.values()[i];
    const double spread = unit, magnitude = allowance;
    const double lastPlace = lastPlaceOf(question.format, magnitude, channel);
    unit = std::max(lastPlace, spread);
    allowance =
        0.5 * timesStored * lastPlace + 2.0 * (spread + (taps + 2.0) * floatRounding * magnitude);
  }
  return expected;
}

Image<double> turned(const Image<double>& image) {
  Image<double> other(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) other(x, y) = image(x, image.height() - 1 - y);
  return other;
}

double mixedAt(const Image<double>& image, double x, double y) {
  const auto at = [&](int i, int j) {
    return image(std::clamp(i, 0, image.width() - 1), std::clamp(j, 0, image.height() - 1));
  };
  const double left = std::floor(x), top = std::floor(y), s = x - left, t = y - top;
  const int i = int(left), j = int(top);
  const auto mix = [](double a, double b, double part) {
    return part == 0.0 ? a : a + part * (b - a);
  };
  if (t == 0.0) return s == 0.0 ? at(i, j) : mix(at(i, j), at(i + 1, j), s);
  return mix(mix(at(i, j), at(i + 1, j), s), mix(at(i, j + 1), at(i + 1, j + 1), s), t);
}

StoredExpectation expectedUnder(const StoredAssumption& assumption,
                                const StoredQuestion& question) {
  StoredExpectation expected = expectedIn(question.map, assumption, question);
  const auto place = [&](Image<double>& image, double scale, double offset) {
    const Image<double> base = std::move(image);
    image = Image<double>(base.width(), base.height());
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        image(x, y) = scale * mixedAt(base, x - assumption.shiftX, y - assumption.shiftY) + offset;
    if (assumption.rowsFromBelow) image = turned(image);
  };
  const double scale = std::abs(assumption.scale), offset = std::abs(assumption.offset);
  place(expected.values, assumption.scale, assumption.offset);
  place(expected.unit, scale, 0.0);
  // The offset itself is rounded with what it is added to.
  place(expected.allowance, scale, 2.0 * floatRounding * offset);
  return expected;
}

}  // namespace umbra

#include "analysis/errors/ErrorDecomposition.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/errors/BleedReduction.h"

namespace umbra {
namespace {

// Whether at least half of the blocking weight lies within `distance` before the receiver.
bool blockersTouch(const Probe& probe, double distance) {
  double blocking = 0.0, near = 0.0;
  for (const RegionTexel& texel : probe.region.texels) {
    if (texel.depth >= probe.receiver) continue;
    blocking += texel.weight;
    if (probe.receiver - texel.depth <= distance) near += texel.weight;
  }
  return near >= 0.5 * blocking;
}

double& at(ErrorParts& parts, ErrorPart part) {
  return parts[std::size_t(part)];
}

}  // namespace

std::string_view nameOf(ErrorPart part) {
  switch (part) {
    case ErrorPart::Bleeding:
      return "bleeding";
    case ErrorPart::ContactLeak:
      return "contactLeak";
    case ErrorPart::OverDarkening:
      return "overDarkening";
    case ErrorPart::Reduction:
      return "reduction";
    case ErrorPart::Precision:
      return "precision";
    case ErrorPart::Small:
      return "small";
  }
  return "";
}

ErrorParts decomposed(double visibility, double reference, const Probe& probe,
                      const DecompositionSettings& settings) {
  ErrorParts parts{};
  const double exact = probe.techniques.front().visibility;
  const double plain = probe.techniques.back().visibility;
  at(parts, ErrorPart::Precision) = visibility - exact;
  at(parts, ErrorPart::Reduction) = exact - plain;
  const double rest = plain - reference;
  if (rest < 0.0)
    at(parts, ErrorPart::OverDarkening) = rest;
  else if (blockersTouch(probe, settings.contactDistance))
    at(parts, ErrorPart::ContactLeak) = rest;
  else
    at(parts, ErrorPart::Bleeding) = rest;
  return parts;
}

std::vector<std::shared_ptr<const Technique>> decompositionTechniques(
    const std::shared_ptr<const Technique>& technique) {
  std::vector<std::shared_ptr<const Technique>> techniques{technique};
  if (bleedReduction(*technique) > 0.0) techniques.push_back(withBleedReduction(*technique, 0.0));
  return techniques;
}

bool worthDecomposing(double visibility, double reference, bool reduces,
                      const DecompositionSettings& settings) {
  if (std::abs(visibility - reference) >= settings.resolution) return true;
  return reduces && visibility < 1.0;
}

void decomposeRow(const SurfaceImage& surfaces, const Image<float>& reference, int y, bool reduces,
                  const PixelProbe& probe, const DecompositionSettings& settings,
                  ErrorDecomposition& result) {
  for (int x = 0; x < surfaces.width(); x += result.stride) {
    if (!surfaces.receivesShadow(x, y)) continue;
    result.receives(x, y) = 1;
    const double visibility = surfaces.visibility(x, y), truth = reference(x, y);
    ErrorParts parts{};
    if (worthDecomposing(visibility, truth, reduces, settings))
      parts = decomposed(visibility, truth, probe(x, y), settings);
    else
      at(parts, ErrorPart::Small) = visibility - truth;
    std::copy(parts.begin(), parts.end(), result.parts.pixel(x, y).begin());
  }
}

ErrorDecomposition emptyDecomposition(int width, int height, int stride) {
  return {Image<double>(width, height, errorPartCount), Image<std::uint8_t>(width, height), stride};
}

ErrorSums sumsOf(const ErrorDecomposition& decomposition, const Image<std::uint8_t>* selection) {
  ErrorSums sums;
  const Image<std::uint8_t>& receives = decomposition.receives;
  for (int y = 0; y < receives.height(); ++y)
    for (int x = 0; x < receives.width(); ++x) {
      if (!receives(x, y) || (selection && !(*selection)(x, y))) continue;
      ++sums.pixels;
      for (int i = 0; i < errorPartCount; ++i) sums.means[i] += decomposition.parts(x, y, i);
    }
  if (sums.pixels == 0) return sums;
  for (double& mean : sums.means) {
    mean /= double(sums.pixels);
    sums.error += mean;
  }
  return sums;
}

double errorAt(const ErrorDecomposition& decomposition, int x, int y,
               std::optional<ErrorPart> part) {
  if (part) return decomposition.parts(x, y, int(*part));
  const auto parts = decomposition.parts.pixel(x, y);
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

std::optional<PicturePixel> worstPixel(const ErrorDecomposition& decomposition,
                                       std::optional<ErrorPart> part,
                                       const Image<std::uint8_t>* selection) {
  std::optional<PicturePixel> worst;
  double largest = 0.0;
  for (int y = 0; y < decomposition.receives.height(); ++y)
    for (int x = 0; x < decomposition.receives.width(); ++x) {
      if (selection && !(*selection)(x, y)) continue;
      const double error = std::abs(errorAt(decomposition, x, y, part));
      if (error <= largest) continue;
      largest = error;
      worst = PicturePixel{x, y};
    }
  return worst;
}

double colourRange(const ErrorDecomposition& decomposition, std::optional<ErrorPart> part) {
  constexpr double within = 0.95;
  std::vector<double> errors;
  for (int y = 0; y < decomposition.receives.height(); ++y)
    for (int x = 0; x < decomposition.receives.width(); ++x)
      if (const double error = errorAt(decomposition, x, y, part); error != 0.0)
        errors.push_back(std::abs(error));
  if (errors.empty()) return 0.01;
  const auto last = errors.begin() + std::ptrdiff_t(std::ceil(within * double(errors.size()))) - 1;
  std::nth_element(errors.begin(), last, errors.end());
  for (const double end : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5})
    if (*last <= end) return end;
  return 1.0;
}

Image<std::uint8_t> lassoMask(std::span<const LassoPoint> polygon, int width, int height) {
  Image<std::uint8_t> mask(width, height);
  std::vector<double> crossings;
  for (int y = 0; y < height; ++y) {
    const double row = y + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const LassoPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= row) != (b.y <= row))
        crossings.push_back(a.x + (row - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      // The pixels whose centres x + ½ lie in [from, to).
      const int from = int(std::ceil(std::clamp(crossings[i], 0.0, double(width)) - 0.5));
      const int to = int(std::ceil(std::clamp(crossings[i + 1], 0.0, double(width)) - 0.5));
      for (int x = from; x < to; ++x) mask(x, y) = 1;
    }
  }
  return mask;
}

}  // namespace umbra

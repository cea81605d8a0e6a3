// The error of a frame taken apart by its causes, pixel by pixel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "analysis/errors/Metrics.h"
#include "analysis/errors/WorstPixel.h"
#include "analysis/probe/Probe.h"
#include "filters/core/maps/Image.h"

namespace umbra {

// Of the signed error e = v − v_ref of a pixel. The parts of a pixel add up to it.
enum class ErrorPart {
  Bleeding,       // > 0: light that passes occluders at a distance
  ContactLeak,    // > 0: light that passes occluders which nearly touch the receiver
  OverDarkening,  // < 0: a shadow where the technique should be lit, without any reduction
  Reduction,      // ≤ 0: what light-bleeding reduction takes away
  Precision,      // v as drawn, from stored channels in the GPU's arithmetic, less v in double
  Small,          // an error below the resolution, which was not taken apart
};
inline constexpr int errorPartCount = 6;
std::string_view nameOf(ErrorPart part);  // "bleeding", "contactLeak": as in files

struct DecompositionSettings {
  // Errors below it are not worth a region.
  double resolution = visibleError;
  // A leak is at a contact where at least half of what blocks, by weight, lies within this
  // distance before the receiver, in normalised depth. At 0.01 the usual smallest variance of
  // 1e-6 still lets 1 % of the light through, and ESM's warp of c = 80 still e^−0.8 of it: up to
  // there light leaks by how a technique resolves depth, not by the variance of a whole region.
  double contactDistance = 0.01;
};

using ErrorParts = std::array<double, errorPartCount>;  // by ErrorPart

// The probe of one pixel in double, with the technique as set and, if it reduces light bleeding,
// once more without: its one or two results, in this order.
using PixelProbe = std::function<Probe(int x, int y)>;

// `visibility` and `reference` as drawn.
ErrorParts decomposed(double visibility, double reference, const Probe& probe,
                      const DecompositionSettings& settings = {});

// What the probe of a pixel is asked for: the technique and, where it has a light-bleeding
// reduction set, a copy without.
std::vector<std::shared_ptr<const Technique>> decompositionTechniques(
    const std::shared_ptr<const Technique>& technique);

struct ErrorDecomposition {
  // errorPartCount channels, by ErrorPart; 0 where no shadow falls.
  Image<double> parts;
  // Pixels that receive shadow and were taken are 1, others 0.
  Image<std::uint8_t> receives;
  // Every how-manieth pixel of every how-manieth row is taken, from (0, 0) on.
  int stride = 1;

  // The taken pixel that stands for (x, y).
  PicturePixel takenPixel(int x, int y) const { return {x - x % stride, y - y % stride}; }
};

// Whether a pixel's error is taken apart, or counted as small. `reduces` says that the technique
// has a light-bleeding reduction: then a pixel without error may owe that to two errors that cancel
// out, but what was drawn lit all the way is not reduced.
bool worthDecomposing(double visibility, double reference, bool reduces,
                      const DecompositionSettings& settings);

// The taken pixels of row `y` of a frame, into a decomposition of its size; rows may be taken apart
// in any order and at the same time. `surfaces` and `reference` as ShadowRenderer gives them.
// `probe` is only called for pixels that are worth it.
void decomposeRow(const Image<float>& surfaces, const Image<float>& reference, int y, bool reduces,
                  const PixelProbe& probe, const DecompositionSettings& settings,
                  ErrorDecomposition& result);
ErrorDecomposition emptyDecomposition(int width, int height, int stride = 1);

struct ErrorSums {
  std::size_t pixels = 0;  // that receive shadow
  ErrorParts means{};      // over these pixels; 0 without any
  double error = 0.0;      // mean signed error: the sum of the means
};
// Over the frame, or over the pixels of `selection` (same size) that are not 0.
ErrorSums sumsOf(const ErrorDecomposition& decomposition,
                 const Image<std::uint8_t>* selection = nullptr);

// Of a pixel: one part, or the whole error where none is named. 0 where no shadow falls.
double errorAt(const ErrorDecomposition& decomposition, int x, int y,
               std::optional<ErrorPart> part);
// Where that is largest, whatever its sign; over the frame, or over the pixels of `selection`. None
// where it is 0 everywhere.
std::optional<PicturePixel> worstPixel(const ErrorDecomposition& decomposition,
                                       std::optional<ErrorPart> part,
                                       const Image<std::uint8_t>* selection = nullptr);
// An end e for a scale of colours [−e, e]: the smallest of 0.01, 0.02, 0.05, 0.1, 0.2, 0.5 and 1
// that 95 % of what is not 0 lies within.
double colourRange(const ErrorDecomposition& decomposition, std::optional<ErrorPart> part);

struct LassoPoint {
  double x = 0.0, y = 0.0;  // of the picture, pixels; pixel (0, 0) covers [0,1)²
};
// 1 for pixels whose centre lies inside the closed polygon, by the even–odd rule.
Image<std::uint8_t> lassoMask(std::span<const LassoPoint> polygon, int width, int height);

}  // namespace umbra

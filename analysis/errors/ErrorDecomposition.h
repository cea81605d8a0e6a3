// The error of a frame taken apart by its causes, pixel by pixel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "analysis/errors/WorstPixel.h"
#include "analysis/probe/Probe.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {

// The parts of a pixel's signed error e = v − v_ref; they add up to it.
enum class ErrorPart {
  Bleeding,       // > 0: light that passes occluders far before the receiver
  ContactLeak,    // > 0: light that passes occluders which nearly touch the receiver
  OverDarkening,  // < 0: a shadow where the technique should be lit, even without any reduction
  Reduction,      // ≤ 0: the light that light-bleeding reduction takes away
  Precision,      // v as drawn, from stored channels in the GPU's arithmetic, minus v in double
  Small,          // an error below `resolution`, which was not taken apart
};
inline constexpr int errorPartCount = 6;
std::string_view nameOf(ErrorPart part);  // "bleeding", "contactLeak": as in files

struct DecompositionSettings {
  // Errors below it are not taken apart.
  double resolution = visibleError;
  // A leak counts as a leak at a contact where at least half of the blocking weight lies within
  // this distance before the receiver, in normalised depth. At 0.01 the usual smallest variance of
  // 1e-6 still lets 1 % of the light through, and ESM's warp of c = 80 still e^−0.8 of it. Up to
  // this distance light leaks because a technique resolves depth no better, and not because of the
  // variance of a whole region.
  double contactDistance = 0.01;
};

using ErrorParts = std::array<double, errorPartCount>;  // by ErrorPart

// Probes one pixel in double, with the technique as it is set and, if it reduces light bleeding,
// once more without reduction. The probe has these one or two results, in this order.
using PixelProbe = std::function<Probe(int x, int y)>;

// `visibility` and `reference` are the drawn values.
ErrorParts decomposed(double visibility, double reference, const Probe& probe,
                      const DecompositionSettings& settings = {});

// The techniques that the probe of a pixel must have: the technique itself and, where it has a
// light-bleeding reduction set, a copy without it.
std::vector<std::shared_ptr<const Technique>> decompositionTechniques(
    const std::shared_ptr<const Technique>& technique);

struct ErrorDecomposition {
  // errorPartCount channels, by ErrorPart; 0 where no shadow falls.
  Image<double> parts;
  // Pixels that receive shadow and were taken are 1, others 0.
  Image<std::uint8_t> receives;
  // Only every stride-th pixel of every stride-th row is taken, from (0, 0) on.
  int stride = 1;

  // The taken pixel that represents (x, y).
  PicturePixel takenPixel(int x, int y) const { return {x - x % stride, y - y % stride}; }
};

// Whether a pixel's error is taken apart, or counted as small. `reduces` says that the technique
// has a light-bleeding reduction. Then a small error may be two errors that cancel out, unless the
// pixel was drawn fully lit, since such a pixel is not reduced.
bool worthDecomposing(double visibility, double reference, bool reduces,
                      const DecompositionSettings& settings);

// Takes the pixels of row `y` of a frame apart, into a decomposition of the frame's size. Rows may
// be taken apart in any order and at the same time. `reference` is that of ShadowRenderer. `probe`
// is called only for pixels that are worth it.
void decomposeRow(const SurfaceImage& surfaces, const Image<float>& reference, int y, bool reduces,
                  const PixelProbe& probe, const DecompositionSettings& settings,
                  ErrorDecomposition& result);
ErrorDecomposition emptyDecomposition(int width, int height, int stride = 1);

struct ErrorSums {
  std::size_t pixels = 0;  // pixels that receive shadow
  ErrorParts means{};      // means over these pixels; 0 where there are none
  double error = 0.0;      // mean signed error: the sum of the means
};
// Sums over the frame, or over the pixels of `selection` (same size) that are not 0.
ErrorSums sumsOf(const ErrorDecomposition& decomposition,
                 const Image<std::uint8_t>* selection = nullptr);

// One part of a pixel's error, or the whole error where `part` is empty. 0 where no shadow falls.
double errorAt(const ErrorDecomposition& decomposition, int x, int y,
               std::optional<ErrorPart> part);
// The pixel where errorAt is largest in magnitude, in the frame or among the pixels of `selection`.
// Nothing where it is 0 everywhere.
std::optional<PicturePixel> worstPixel(const ErrorDecomposition& decomposition,
                                       std::optional<ErrorPart> part,
                                       const Image<std::uint8_t>* selection = nullptr);
// The end e of a scale of colours [−e, e]: the smallest of 0.01, 0.02, 0.05, 0.1, 0.2, 0.5 and 1
// that holds 95 % of the errors other than 0.
double colourRange(const ErrorDecomposition& decomposition, std::optional<ErrorPart> part);

struct LassoPoint {
  double x = 0.0, y = 0.0;  // pixels of the picture; pixel (0, 0) covers [0,1)²
};
// A mask that is 1 for pixels whose centre lies inside the closed polygon, by the even–odd rule.
Image<std::uint8_t> lassoMask(std::span<const LassoPoint> polygon, int width, int height);

}  // namespace umbra

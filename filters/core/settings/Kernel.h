// The prefilter's kernel: square, separable, (2r+1)² taps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbra {

enum class KernelShape { None, Box, Gaussian };

struct Kernel {
  static constexpr int largestRadius = 64;
  // The range of a sigma that is set. Far below it, the weights beside the centre are not even
  // subnormal.
  static constexpr double smallestSigma = 0.01, largestSigma = 1000.0;

  KernelShape shape = KernelShape::Box;
  int radius = 3;      // texels, 0 … largestRadius; None counts as 0
  double sigma = 0.0;  // texels, smallestSigma … largestSigma; 0 means radius / 2, the default

  int effectiveRadius() const { return shape == KernelShape::None ? 0 : radius; }
  double effectiveSigma() const { return sigma > 0.0 ? sigma : radius / 2.0; }

  // The weights along one axis: 2r+1 values, symmetric, sum 1. The Gaussian is sampled at texel
  // centres and normalised over its support.
  std::vector<double> weights() const;

  bool operator==(const Kernel&) const = default;
};

std::string_view nameOf(KernelShape shape);
// For labels: "box 7×7", "Gaussian 7×7, σ 1.5", "no prefilter".
std::string describe(const Kernel& kernel);

}  // namespace umbra

#include "filters/core/settings/Kernel.h"

#include <cmath>
#include <numeric>

#include "filters/core/support/Text.h"

namespace umbra {

std::vector<double> Kernel::weights() const {
  const int r = effectiveRadius();
  std::vector<double> weights(2 * r + 1, 1.0);
  if (shape == KernelShape::Gaussian && r > 0) {
    const double s = effectiveSigma();
    for (int i = -r; i <= r; ++i) weights[i + r] = std::exp(-0.5 * i * i / (s * s));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::string_view nameOf(KernelShape shape) {
  switch (shape) {
    case KernelShape::None:
      return "none";
    case KernelShape::Box:
      return "box";
    case KernelShape::Gaussian:
      return "gaussian";
  }
  return "";
}

std::string describe(const Kernel& kernel) {
  if (kernel.effectiveRadius() == 0) return "no prefilter";
  const std::string side = std::to_string(2 * kernel.radius + 1);
  const std::string size = side + "×" + side;
  if (kernel.shape == KernelShape::Box) return "box " + size;
  return "Gaussian " + size + ", σ " + shortNumber(kernel.effectiveSigma());
}

}  // namespace umbra

// The truncated Fourier series of the shadow test, as convolution shadow maps use it, in plots.
#pragma once

#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// f(t) = ½ + 2 Σ (a_k/c_k) sin(c_k t) over t = z − d, occluder's less receiver's depth, with
// c_k = π(2k − 1) and a_k = e^{−α(k/M)²} for k = 1 … M (Annen 2007, eq. 11 with the
// sign of eq. 13, and §3.2.1). The step
// that it stands for is 1 for t ≥ 0.
class FourierStep {
 public:
  FourierStep(int terms, double attenuation);  // terms ≥ 1

  int terms() const { return int(coefficients_.size()); }
  double operator()(double t) const;
  // The smallest t > 0 at which f is 1, or the place of its maximum where it never is: how far
  // offset mode moves the receiver towards the light (§3.2.2).
  double offset() const { return offset_; }

  // The same summed over a region, of which only the means of sine and cosine are needed
  // (eq. 13–14). Of the receiver's depth, neither offset nor clamped.
  std::vector<double> over(const Region& region, const std::vector<double>& receivers) const;

 private:
  double findOffset() const;

  std::vector<double> coefficients_;  // 2 a_k/c_k
  double offset_ = 0.0;
};

// The step, the series as it is and attenuated, and what offset and scale mode make of it (Annen
// 2007, fig. 3), with the largest swing beyond 1 marked. `terms` ≥ 1; an attenuation of 0 is shown
// beside one of 1.
Plot fourierStepPlot(int terms, double attenuation);
// With the parameters of the probe's technique csm, or its defaults where it is not among them.
Plot fourierStepPlot(const Probe& probe);

// Visibility of the region from series of 1, 2, 4, 8 and 16 terms in offset mode, over the
// receiver's depth, beside the exact one.
Plot fourierTermsPlot(const Probe& probe);

}  // namespace umbra

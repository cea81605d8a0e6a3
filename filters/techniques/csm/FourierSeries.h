// The truncated Fourier series of the shadow test (Annen et al. 2007, §3.1–3.2).
#pragma once

#include <array>
#include <numbers>

namespace umbra::csm {

inline constexpr int largestTermCount = 16;

// c_k = π(2k − 1), for k from 1.
inline double frequency(int k) {
  return std::numbers::pi * (2 * k - 1);
}

// h(t) = ½ + 2 Σ (a_k/c_k) sin(c_k t), the series of the step at t = z − d, with every term
// attenuated by a_k = e^{−α (k/M)²} (§3.2.1).
class FourierSeries {
 public:
  FourierSeries() : FourierSeries(4, 0.0) {}
  FourierSeries(int terms, double attenuation);

  int terms() const { return terms_; }
  double attenuation() const { return attenuation_; }
  // 2 a_k/c_k, for k from 1.
  double coefficient(int k) const { return coefficients_[k - 1]; }
  double operator()(double t) const;
  // How far the receiver is moved towards the light in offset mode (§3.2.2): the smallest t > 0
  // with h(t) = 1, or the place of the maximum where h never reaches 1.
  double offset() const { return offset_; }

 private:
  double slope(double t) const;
  double findOffset() const;

  int terms_;
  double attenuation_;
  std::array<double, largestTermCount> coefficients_{};
  double offset_ = 0.0;
};

}  // namespace umbra::csm

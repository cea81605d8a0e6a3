// The waves of all terms at one place, by two calls of the sine and cosine instead of two a term.
#pragma once

#include <cmath>
#include <numbers>

namespace umbra::csm {

// sin(c_k x) and cos(c_k x) with c_k = π(2k − 1), for k = 1, and after each call of `next` for the
// next k: both turn by 2πx. The angle's rounding turns with them: term k is off by some 10⁻¹⁵ k.
class Waves {
 public:
  explicit Waves(double x)
      : sine_(std::sin(std::numbers::pi * x)),
        cosine_(std::cos(std::numbers::pi * x)),
        turnSine_(2.0 * sine_ * cosine_),
        turnCosine_(1.0 - 2.0 * sine_ * sine_) {}

  double sine() const { return sine_; }
  double cosine() const { return cosine_; }
  void next() {
    const double sine = sine_ * turnCosine_ + cosine_ * turnSine_;
    cosine_ = cosine_ * turnCosine_ - sine_ * turnSine_;
    sine_ = sine;
  }

 private:
  double sine_, cosine_, turnSine_, turnCosine_;
};

}  // namespace umbra::csm

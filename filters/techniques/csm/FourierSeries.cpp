#include "filters/techniques/csm/FourierSeries.h"

#include <cmath>

namespace umbra::csm {
namespace {

// Where `f` changes sign between a and b, to the last bit: f(a) and f(b) differ in sign.
template <class F>
double bisect(F f, double a, double b) {
  const bool sign = f(a) > 0.0;
  for (;;) {
    const double middle = a + 0.5 * (b - a);
    if (middle <= a || middle >= b) return middle;
    ((f(middle) > 0.0) == sign ? a : b) = middle;
  }
}

}  // namespace

FourierSeries::FourierSeries(int terms, double attenuation)
    : terms_(terms), attenuation_(attenuation) {
  for (int k = 1; k <= terms_; ++k) {
    const double share = double(k) / terms_;
    coefficients_[k - 1] = 2.0 * std::exp(-attenuation_ * share * share) / frequency(k);
  }
  offset_ = findOffset();
}

double FourierSeries::operator()(double t) const {
  double sum = 0.5;
  for (int k = 1; k <= terms_; ++k) sum += coefficients_[k - 1] * std::sin(frequency(k) * t);
  return sum;
}

double FourierSeries::slope(double t) const {
  double sum = 0.0;
  for (int k = 1; k <= terms_; ++k)
    sum += coefficients_[k - 1] * frequency(k) * std::cos(frequency(k) * t);
  return sum;
}

// h rises from ½ at t = 0 and is symmetric about t = ½, where it has its last extreme that
// counts. Its fastest wave is 1/(M − ½) long; steps of 1/(64 M) miss no extreme.
double FourierSeries::findOffset() const {
  const double step = 1.0 / (64.0 * terms_);
  double valley = 0.0, best = 0.0;
  for (double t = 0.0; t < 0.5 + step; t += step) {
    const bool rising = slope(t) > 0.0, risesNext = slope(t + step) > 0.0;
    if (rising == risesNext) continue;
    const double extreme = bisect([this](double x) { return slope(x); }, t, t + step);
    if (!rising) {
      valley = extreme;
    } else if ((*this)(extreme) >= 1.0) {
      return bisect([this](double x) { return (*this)(x)-1.0; }, valley, extreme);
    } else if (best == 0.0 || (*this)(extreme) > (*this)(best)) {
      best = extreme;
    }
  }
  return best;
}

}  // namespace umbra::csm

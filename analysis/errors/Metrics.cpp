#include "analysis/errors/Metrics.h"

#include <algorithm>
#include <cmath>

namespace umbra {

void MetricsSum::add(double visibility, double reference) {
  const double error = visibility - reference;
  max_ = samples_ == 0 ? error : std::max(max_, error);
  min_ = samples_ == 0 ? error : std::min(min_, error);
  ++samples_;
  squares_ += error * error;
  positive_ += std::max(error, 0.0);
  negative_ += std::max(-error, 0.0);
  if (reference == 0.0) {
    ++umbraSamples_;
    umbra_ += error;
  }
}

void MetricsSum::add(const MetricsSum& other) {
  if (other.samples_ == 0) return;
  max_ = samples_ == 0 ? other.max_ : std::max(max_, other.max_);
  min_ = samples_ == 0 ? other.min_ : std::min(min_, other.min_);
  samples_ += other.samples_;
  umbraSamples_ += other.umbraSamples_;
  squares_ += other.squares_;
  positive_ += other.positive_;
  negative_ += other.negative_;
  umbra_ += other.umbra_;
}

Metrics MetricsSum::result() const {
  Metrics m{.samples = samples_, .max = max_, .min = min_};
  if (samples_ == 0) return m;
  const double n = double(samples_);
  m.rmse = std::sqrt(squares_ / n);
  m.mae = (positive_ + negative_) / n;
  m.bleeding = positive_ / n;
  m.darkening = negative_ / n;
  m.umbraBleeding = umbraSamples_ > 0 ? umbra_ / double(umbraSamples_) : 0.0;
  return m;
}

}  // namespace umbra

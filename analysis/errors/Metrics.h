// How far techniques are from the reference over many receivers.
#pragma once

#include <cstddef>

namespace umbra {

// Statistics of errors e = visibility − reference.
struct Metrics {
  std::size_t samples = 0;
  double rmse = 0.0, mae = 0.0;
  double bleeding = 0.0;   // mean of max(e, 0)
  double darkening = 0.0;  // mean of max(−e, 0)
  double max = 0.0, min = 0.0;
  double umbraBleeding = 0.0;  // mean of e over the samples whose reference is 0; 0 without any
};

class MetricsSum {
 public:
  void add(double visibility, double reference);
  // As if the other's samples had been added after its own; sums of parts are rounded apart.
  void add(const MetricsSum& other);
  Metrics result() const;

 private:
  std::size_t samples_ = 0, umbraSamples_ = 0;
  double squares_ = 0.0, positive_ = 0.0, negative_ = 0.0, umbra_ = 0.0;
  double max_ = 0.0, min_ = 0.0;
};

}  // namespace umbra

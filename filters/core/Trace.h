// Why a technique's visibility is what it is: its evaluation, step by step.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

struct TraceStep {
  std::string symbol;   // "σ²", as the paper writes it
  std::string meaning;  // "variance of the region's depths"
  std::string formula;  // "M2 − M1²"; empty for what is given
  double value = 0.0;
};

// What makes a visibility wrong.
enum class ErrorCause {
  None,
  DistantVariance,    // occluders far apart raise the bound: light bleeding
  EarlyOut,           // the receiver is before the mean and counts as lit
  VarianceClamp,      // the smallest variance softens what is sharp
  StoredPrecision,    // rounding in the storage format
  ExponentLimit,      // a warp's exponent was cut to what the format holds
  ContactLeak,        // receiver and occluder nearer than the warp resolves
  Ringing,            // a Fourier sum that swings about the truth
  LayerCut,           // a layer's end cuts occluders off
  CollapsedPenumbra,  // a power CDF whose receiver is its farthest depth
  BoundSlack,         // a bound that the depths do not reach
  Reduction,          // light-bleeding reduction darkens what was right
  Sampling,           // too few taps
};

struct Trace {
  std::vector<TraceStep> steps;
  ErrorCause cause = ErrorCause::None;
  std::optional<int> culprit;  // index into `steps` of the step that goes wrong
  std::string sentence;        // the cause with this region's numbers, for a person
};

std::string_view nameOf(ErrorCause cause);

}  // namespace umbra

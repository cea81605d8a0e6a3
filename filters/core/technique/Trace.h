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
  std::string formula;  // "M2 − M1²"; empty for a value that is given
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
  ContactLeak,        // the receiver is nearer to its occluder than the warp resolves
  Ringing,            // a Fourier sum that swings about the step
  LayerCut,           // a layer's end cuts occluders off
  CollapsedPenumbra,  // a power CDF whose receiver is its farthest depth
  BoundSlack,         // a bound that the depths do not reach
  Reduction,          // light-bleeding reduction darkens what was right
  Sampling,           // too few taps
  Misfit,             // depths that are not distributed as the technique assumes
  Wrapping,           // a series that repeats within the depth range
};

// What one cause does to the visibility: positive brightens. The shares of a trace sum to its
// error.
struct ErrorShare {
  ErrorCause cause = ErrorCause::None;
  int step = 0;  // index of the step that does it
  double amount = 0.0;
};

struct Trace {
  std::vector<TraceStep> steps;
  std::vector<ErrorShare> shares;
  ErrorCause cause = ErrorCause::None;
  std::optional<int> culprit;  // index into `steps` of the step that goes wrong
  std::string sentence;        // the cause with this region's numbers, for a person
};

std::string_view nameOf(ErrorCause cause);

// Takes the steps of an evaluation and gives each value back, so that one function computes a
// visibility and explains it.
class TraceRecorder {
 public:
  // Keeps `trace`, which must outlive it. `suffix` is appended to every symbol; that of a numbered
  // one, for layers and terms, is like "₁₂".
  explicit TraceRecorder(Trace& trace, std::string suffix = {})
      : trace_(&trace), suffix_(std::move(suffix)) {}

  double operator()(std::string_view symbol, std::string_view meaning, std::string_view formula,
                    double value) const {
    trace_->steps.push_back(
        {std::string(symbol) + suffix_, std::string(meaning), std::string(formula), value});
    return value;
  }
  TraceRecorder withSuffix(std::string suffix) const {
    return TraceRecorder(*trace_, std::move(suffix));
  }
  TraceRecorder numbered(int number) const { return withSuffix(numberText(number)); }
  static std::string numberText(int number);

 private:
  Trace* trace_;
  std::string suffix_;
};

// A recorder for where nobody asks for a trace: it keeps nothing and costs nothing.
struct Unrecorded {
  double operator()(std::string_view, std::string_view, std::string_view, double value) const {
    return value;
  }
  Unrecorded withSuffix(std::string_view) const { return {}; }
  Unrecorded numbered(int) const { return {}; }
};

}  // namespace umbra

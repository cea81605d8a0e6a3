#include "filters/core/technique/Trace.h"

namespace umbra {

std::string_view nameOf(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::None:
      return "none";
    case ErrorCause::DistantVariance:
      return "variance of distant occluders";
    case ErrorCause::EarlyOut:
      return "early-out";
    case ErrorCause::VarianceClamp:
      return "variance clamp";
    case ErrorCause::StoredPrecision:
      return "stored precision";
    case ErrorCause::ExponentLimit:
      return "exponent limit";
    case ErrorCause::ContactLeak:
      return "contact leak";
    case ErrorCause::Ringing:
      return "ringing";
    case ErrorCause::LayerCut:
      return "layer cut";
    case ErrorCause::CollapsedPenumbra:
      return "collapsed penumbra";
    case ErrorCause::BoundSlack:
      return "slack of the bound";
    case ErrorCause::Reduction:
      return "light-bleeding reduction";
    case ErrorCause::Sampling:
      return "sampling";
    case ErrorCause::Misfit:
      return "misfit";
    case ErrorCause::Wrapping:
      return "wrapping of the series";
  }
  return "";
}

std::string TraceRecorder::numberText(int number) {
  static constexpr std::string_view digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  for (char digit : std::to_string(number)) text += digits[digit - '0'];
  return text;
}

}  // namespace umbra

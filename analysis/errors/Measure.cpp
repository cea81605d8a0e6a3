#include "analysis/errors/Measure.h"

#include "analysis/probe/Explain.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {

std::optional<double> measured(const Probe& probe, Quantity quantity, std::string_view technique) {
  const TechniqueResult* result = resultOf(probe, technique);
  const QuantityInfo& info = infoOf(quantity);
  if (info.ofFrame || (info.ofTechnique && !result)) return std::nullopt;
  switch (quantity) {
    case Quantity::Reference:
      return probe.reference;
    case Quantity::Receiver:
      return probe.receiver;
    case Quantity::Mean:
      return probe.statistics.mean;
    case Quantity::Variance:
      return probe.statistics.variance;
    case Quantity::Minimum:
      return probe.statistics.min;
    case Quantity::Maximum:
      return probe.statistics.max;
    case Quantity::Taps:
      return double(probe.region.texels.size());
    case Quantity::Visibility:
      return result->visibility;
    case Quantity::Error:
      return result->error;
    case Quantity::Channels:
      return double(result->technique->channels().size());
    default:
      return std::nullopt;
  }
}

double measured(const Metrics& metrics, Quantity quantity) {
  switch (quantity) {
    case Quantity::Bleeding:
      return metrics.bleeding;
    case Quantity::Darkening:
      return metrics.darkening;
    case Quantity::UmbraBleeding:
      return metrics.umbraBleeding;
    default:
      return metrics.rmse;
  }
}

std::string causeOf(const Probe& probe, std::string_view technique) {
  const TechniqueResult* result = resultOf(probe, technique);
  if (!result) return {};
  return explain(probe, *result).sentence;
}

const char* verdictOf(double error) {
  if (!isVisibleError(error)) return "no visible error";
  return error > 0.0 ? "light bleeding" : "over-darkening";
}

}  // namespace umbra

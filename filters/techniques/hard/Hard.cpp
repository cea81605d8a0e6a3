#include "filters/techniques/hard/Hard.h"

#include "Hard_glsl.h"
#include "Hard_md.h"
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra::hard {

const TechniqueInfo& Hard::info() const {
  static constexpr TechniqueInfo info{
      .id = "hard",
      .title = "Hard shadow map",
      .citation = "Williams 1978",
      .summary = "Stores depth and compares the one texel nearest to the read position.",
      .formula = "v = 1 for z_r ≤ z, else 0",
      .order = 0,
      .prefilterable = false,
      .colour = "#9aa5b1"};
  return info;
}

void Hard::encode(double z, std::span<double> channels) const {
  channels[0] = z;
}

namespace {

template <class Record>
double compared(const Region& region, double receiver, const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  record("z", "depth of the nearest texel", "", region.nearestDepth);
  return record("v", "visibility: one comparison", "1 for z_r ≤ z, else 0",
                receiver <= region.nearestDepth ? 1.0 : 0.0);
}

}  // namespace

double Hard::visibility(const Fetch& fetch, double receiver) const {
  return compared(fetch.region, receiver, Unrecorded());
}

Trace Hard::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  compared(fetch.region, receiver, TraceRecorder(trace));
  ErrorShares shares(trace, fetch, receiver);
  shares.rest(ErrorCause::Sampling, "z",
              "one texel of the region's " + std::to_string(fetch.region.texels.size()) +
                  " taps is compared, and it speaks for all; " + shortNumber(shares.reference()) +
                  " of their weight is lit.");
  shares.decide("all texels of the region agree with the nearest.");
  return trace;
}

std::string_view Hard::glsl() const {
  return Hard_glsl;
}
std::string_view Hard::page() const {
  return Hard_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Hard>());
}

}  // namespace umbra::hard

#include "filters/techniques/msm/Msm.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "Msm_glsl.h"
#include "Msm_md.h"
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/msm/Hamburger.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::msm {

// It is not marked as an upper bound, since the moment bias lowers the result by up to half of the
// bias.
const TechniqueInfo& Msm::info() const {
  static constexpr TechniqueInfo info{
      .id = "msm",
      .title = "Moments (MSM)",
      .citation = "Peters & Klein 2015, algorithm 3",
      .summary = "Stores four power moments of depth; the sharpest bound that they allow.",
      .formula = "v = largest P(z ≥ z_r) over all distributions with moments M1 … M4",
      .order = 90,
      // 8 to scale four stored channels, 12 from the quantised basis to the moments of 2z − 1, 13
      // to those of z, 9 for the moment bias, 24 for the Hankel system, 11 for its two roots and
      // their comparison with z_r, 11 for the occluded share, 5 for the reduction of bleeding.
      .roundings = 93,
      .colour = "#6b8e23"};
  return info;
}

std::vector<std::string> Msm::limitTo(StorageFormat format) {
  std::vector<std::string> changes;
  const bool coarse = unitRoundoff(format) > unitRoundoff(StorageFormat::Float);
  if (coarse && values.basis == Basis::Moments) {
    values.basis = Basis::Quantised;
    changes.push_back("msm.basis moments loses too many digits in " + std::string(nameOf(format)) +
                      "; quantised is used");
  }
  // Rounded moments need not belong to any distribution. A bias below the worth of their last digit
  // leaves a system that amplifies their error without bound.
  const double smallest = 2.0 * unitRoundoff(format);
  if (values.momentBias < smallest) {
    values.momentBias = smallest;
    changes.push_back("msm.moment-bias is below what " + std::string(nameOf(format)) +
                      " resolves; " + shortNumber(smallest) + " is used");
  }
  return changes;
}

void Msm::encode(double z, std::span<double> channels) const {
  const double z2 = z * z;
  const Moments4 stored =
      values.basis == Basis::Quantised ? toQuantised(z) : Moments4{z, z2, z2 * z, z2 * z2};
  std::copy(stored.begin(), stored.end(), channels.begin());
}

namespace {

Moments4 momentsOf(std::span<const double> channels, Basis basis) {
  Moments4 moments;
  std::copy_n(channels.begin(), 4, moments.begin());
  return basis == Basis::Quantised ? fromQuantised(moments) : moments;
}

// The same technique with the smallest bias with which a system in double can be solved.
constexpr double hardlyAnyBias = 1e-9;

}  // namespace

double Msm::visibility(const Fetch& fetch, double receiver) const {
  const Moments4 moments = momentsOf(fetch.channels, values.basis);
  return reduceLightBleeding(hamburgerVisibility(moments, receiver, values.momentBias),
                             values.bleedReduction);
}

// The pivots of the Hankel matrix that is biased by α are no smaller than about √α.
double Msm::amplification() const {
  return reductionSlope(values.bleedReduction) / std::sqrt(values.momentBias);
}

Trace Msm::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  const TraceRecorder record(trace);
  record("z_r", "receiver's depth, biased", "", receiver);
  const Moments4 moments = momentsOf(fetch.channels, values.basis);
  for (int k = 0; k < 4; ++k)
    record.numbered(k + 1)("M", "moment of the region's depths", "", moments[k]);
  const double bound = hamburgerVisibility(moments, receiver, values.momentBias, record);
  record("a", "light-bleeding reduction", "", values.bleedReduction);
  record("v", "visibility", "clamp((p_max − a)/(1 − a), 0, 1)",
         reduceLightBleeding(bound, values.bleedReduction));

  ErrorShares shares(trace, fetch, receiver);
  shares.without(ErrorCause::Reduction, "v", bound,
                 "the light-bleeding reduction takes a part of every penumbra; the bound itself "
                 "is " +
                     shortNumber(bound) + ".");
  const Moments4 exact = momentsOf(exactMeans(*this, fetch), values.basis);
  const double precise = hamburgerVisibility(exact, receiver, values.momentBias);
  shares.without(ErrorCause::StoredPrecision, "D₂", precise,
                 "the stored moments are rounded, and the pivots are small differences of them; "
                 "from exact moments v would be " +
                     shortNumber(precise) + ".");
  const double unbiased =
      hamburgerVisibility(exact, receiver, std::min(values.momentBias, hardlyAnyBias));
  shares.without(ErrorCause::VarianceClamp, "α", unbiased,
                 "the moment bias blurs the depths by a little, as a smallest variance does; "
                 "without it v would be " +
                     shortNumber(unbiased) + ".");
  shares.rest(ErrorCause::BoundSlack, "p_max",
              "the four moments also belong to other depths than these, of which " +
                  shortNumber(shares.reference()) +
                  " are lit: the bound is that of the worst three, z₁, z_r and z₂.");
  shares.decide("four moments leave these depths hardly any choice.");
  return trace;
}

std::string_view Msm::glsl() const {
  return Msm_glsl;
}
std::string_view Msm::page() const {
  return Msm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Msm>());
}

}  // namespace umbra::msm

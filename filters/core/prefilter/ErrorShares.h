// Finds out which step of an evaluation makes its visibility wrong. Causes are taken away one after
// the other until the exact visibility is left; each is charged with what its absence changed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filters/core/technique/Technique.h"

namespace umbra {

// The depths of a region on one side of the receiver. All members are 0 where these have no weight.
struct DepthGroup {
  double weight = 0.0;
  double mean = 0.0, min = 0.0, max = 0.0;
};
struct Occlusion {
  DepthGroup blocking;  // z < z_r
  DepthGroup lit;       // z ≥ z_r
};
Occlusion occlusionOf(const Region& region, double receiver);

// "0.2", or "0.2 … 0.6" where they differ.
std::string rangeText(const DepthGroup& group);

class ErrorShares {
 public:
  // `trace` holds all steps, the last one is the visibility; it must outlive this object. Where
  // steps occur several times, this object is about those whose symbols end in `suffix`.
  ErrorShares(Trace& trace, const Fetch& fetch, double receiver, std::string suffix = {});

  double reference() const { return reference_; }
  const Occlusion& occlusion() const { return occlusion_; }

  // `visibility` is what would be left without this cause and all that were named before it.
  // `symbol` names the step that is to blame, or the last step where there is none of that symbol;
  // `sentence` says why.
  void without(ErrorCause cause, std::string_view symbol, double visibility, std::string sentence);
  // Charges this cause with all that is left between the visibility and the exact one.
  void rest(ErrorCause cause, std::string_view symbol, std::string sentence);

  // Sets the trace's cause: the largest share in the error's direction, none for an error that
  // cannot be seen (VisibleError.h). `whyRight` says why a penumbra came out right.
  void decide(std::string_view whyRight);

 private:
  std::string verdict(double error, const std::string& sentence, double amount) const;

  int stepOf(std::string_view symbol) const;

  Trace& trace_;
  std::string suffix_;
  double visibility_, reference_, left_;
  Occlusion occlusion_;
  std::vector<std::string> sentences_;  // one for each of the trace's shares
};

// The fetch's channels, with the means computed from the region in double. Minima and maxima stay
// as they were read, since a read may interpolate them.
std::vector<double> exactMeans(const Technique& technique, const Fetch& fetch);

}  // namespace umbra

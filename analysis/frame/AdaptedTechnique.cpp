#include "analysis/frame/AdaptedTechnique.h"

namespace umbra {

std::shared_ptr<const Technique> adaptedTechnique(const Technique& technique, const DepthMap& map,
                                                  std::span<const double> drawn) {
  std::shared_ptr<Technique> copy = technique.clone();
  if (drawn.empty())
    copy->adapt(map);
  else
    copy->setAdaptedSplits(drawn);
  return copy;
}

}  // namespace umbra

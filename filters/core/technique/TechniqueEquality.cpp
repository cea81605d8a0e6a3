#include "filters/core/technique/TechniqueEquality.h"

#include <algorithm>

namespace umbra {

bool sameSettings(const Technique& a, const Technique& b) {
  if (a.info().id != b.info().id) return false;
  // Parameters are bound to an instance that may be changed through them.
  const std::unique_ptr<Technique> left = a.clone(), right = b.clone();
  const std::vector<Parameter> ours = left->parameters(), theirs = right->parameters();
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                    [](const Parameter& x, const Parameter& y) { return x.get() == y.get(); });
}

}  // namespace umbra

#include "filters/core/technique/TechniqueEquality.h"

#include <algorithm>

namespace umbra {

bool sameSettings(const Technique& a, const Technique& b) {
  if (a.info().id != b.info().id) return false;
  const std::vector<ParameterView> ours = a.parameters(), theirs = b.parameters();
  return std::equal(
      ours.begin(), ours.end(), theirs.begin(), theirs.end(),
      [](const ParameterView& x, const ParameterView& y) { return x.get() == y.get(); });
}

}  // namespace umbra

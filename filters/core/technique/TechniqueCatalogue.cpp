#include "filters/core/technique/TechniqueCatalogue.h"

#include <algorithm>
#include <tuple>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

void TechniqueCatalogue::add(std::unique_ptr<Technique> technique) {
  const auto key = [](const auto& t) { return std::tuple(t->info().order, t->info().id); };
  const auto place =
      std::upper_bound(techniques_.begin(), techniques_.end(), technique,
                       [&](const auto& a, const auto& b) { return key(a) < key(b); });
  techniques_.insert(place, std::move(technique));
}

std::vector<const Technique*> TechniqueCatalogue::all() const {
  std::vector<const Technique*> all;
  for (const auto& technique : techniques_) all.push_back(technique.get());
  return all;
}

bool TechniqueCatalogue::has(std::string_view id) const {
  return std::any_of(techniques_.begin(), techniques_.end(),
                     [&](const auto& technique) { return technique->info().id == id; });
}

std::unique_ptr<Technique> TechniqueCatalogue::make(std::string_view id,
                                                    std::string_view where) const {
  std::vector<std::string> ids;
  for (const auto& technique : techniques_) {
    if (technique->info().id == id) return technique->clone();
    ids.emplace_back(technique->info().id);
  }
  const std::string nearest = nearestWord(id, ids);
  throw Error(
      ErrorKind::BadCommandLine,
      std::string(where) + ": there is no '" + clipped(id) + "'; " +
          (nearest.empty() ? "there are " + joined(ids) : "did you mean '" + nearest + "'?"));
}

}  // namespace umbra

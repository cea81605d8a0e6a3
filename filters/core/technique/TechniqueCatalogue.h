// The techniques that there are.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "filters/core/technique/Technique.h"

namespace umbra {

class TechniqueCatalogue {
 public:
  void add(std::unique_ptr<Technique> technique);

  // All techniques, in teaching order.
  std::vector<const Technique*> all() const;
  bool has(std::string_view id) const;
  // A copy with default parameters. Throws BadCommandLine with the nearest id as a suggestion;
  // `where` is what the message begins with: an option, or a file and key.
  std::unique_ptr<Technique> make(std::string_view id, std::string_view where = "technique") const;

 private:
  std::vector<std::unique_ptr<Technique>> techniques_;
};

// Every technique in filters/techniques.
TechniqueCatalogue allTechniques();

}  // namespace umbra

// What a frame was baked into, to be compared.
#pragma once

#include <memory>

namespace umbra {

// The same objects as long as nothing was baked anew; null before the first bake. Who keeps one can
// tell later whether what was read of a frame still holds.
struct Baked {
  std::shared_ptr<const void> firstMap;  // of the first cascade, to which techniques adapt
  std::shared_ptr<const void> maps;      // of all cascades
  std::shared_ptr<const void> channels;  // encoded and prefiltered

  bool operator==(const Baked&) const = default;
};

}  // namespace umbra

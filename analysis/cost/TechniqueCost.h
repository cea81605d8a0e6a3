// What a technique costs in a frame.
#pragma once

#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

struct TechniqueCost {
  double bakeMs = 0.0;   // depths, channels and what is made of them, as after a light's motion
  double shadeMs = 0.0;  // the shaded scene, which a camera's motion costs as well
  // Bytes per texel of the shadow map.
  double bytesStored = 0.0;  // of the channels that the method stores, as the papers count
  double bytesUsed = 0.0;    // of all textures of the program: also depths and room for the filter
};

// The technique's channels, each in the format.
inline double bytesStoredPerTexel(const Technique& technique, StorageFormat format) {
  return double(technique.channels().size()) * bytesOf(format);
}

}  // namespace umbra

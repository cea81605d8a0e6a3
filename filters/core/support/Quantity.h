// What a technique can be asked for by name, at a probe or over a frame: for lessons and reports.
#pragma once

#include <string_view>

namespace umbra {

enum class Quantity {
  // These describe the probed region.
  Reference,  // exact percentage-closer filtering, [0,1]
  Receiver,   // z_r, biased, [0,1]
  Mean,       // μ of the region's depths, [0,1]
  Variance,   // σ² of the region's depths
  Minimum,    // the smallest depth of the region
  Maximum,
  Taps,  // depths in the region
  // These describe one technique at the probe.
  Visibility,  // [0,1]
  Error,       // visibility − reference: positive is light bleeding
  Channels,    // numbers stored per texel
  // These describe one technique over every pixel of the frame that receives shadow.
  Rmse,
  Bleeding,       // mean of max(error, 0)
  Darkening,      // mean of max(−error, 0)
  UmbraBleeding,  // mean error where the reference is 0
};

struct QuantityInfo {
  Quantity quantity;
  std::string_view name;     // "umbra-bleeding", in files
  std::string_view meaning;  // "mean light in full shadow", for people
  bool ofTechnique = false;  // means nothing without one
  bool ofFrame = false;      // of all pixels, not of the probe
};

const QuantityInfo& infoOf(Quantity quantity);
// Throws BadCommandLine for an unknown name and lists the right ones. `where` is what the message
// begins with: an option, or a file and key.
Quantity quantityFrom(std::string_view name, std::string_view where);

}  // namespace umbra

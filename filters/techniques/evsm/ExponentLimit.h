// How far an exponential warp may go in a storage format.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/settings/StorageFormat.h"
#include "filters/core/support/Text.h"

namespace umbra {

// The largest whole c with e^c finite in the format. It limits a warp e^{c(z−½)} whose square is
// stored, since the square reaches e^c at z = 1. A warp that is stored without its square may have
// twice as much. Normalised formats hold no exponential at all.
inline double largestSquaredExponent(StorageFormat format) {
  switch (format) {
    case StorageFormat::Half:
      return 11.0;  // e^11 = 59874 < 65504
    case StorageFormat::Float:
      return 88.0;  // e^88 = 1.65e38 < 3.40e38
    default:
      return std::numeric_limits<double>::infinity();
  }
}

// Cuts `exponent` down to `largest` and, where that changes it, adds a sentence to `notes`.
inline void limitExponent(double& exponent, double largest, std::string_view option,
                          StorageFormat format, std::vector<std::string>& notes) {
  if (exponent <= largest) return;
  notes.push_back(std::string(option) + " " + shortNumber(exponent) + " is beyond what " +
                  (format == StorageFormat::Half ? "half floats" : "32-bit floats") + " hold; " +
                  shortNumber(largest) + " is used");
  exponent = largest;
}

// An exponent that a format cut down, remembered so that a trace can say what it cost.
class CutExponent {
 public:
  void limit(double& exponent, double largest, std::string_view option, StorageFormat format,
             std::vector<std::string>& notes) {
    asked_ = exponent;
    limitExponent(exponent, largest, option, format, notes);
    held_ = exponent;
  }
  // The exponent that was asked for, where the format has cut it down to `exponent`; else
  // `exponent`.
  double asked(double exponent) const { return exponent == held_ ? asked_ : exponent; }

 private:
  double asked_ = 0.0, held_ = 0.0;
};

// A sentence for a trace.
inline std::string exponentLimitText(std::string_view symbol, double held, double asked,
                                     double visibility) {
  return "the storage format holds " + std::string(symbol) + " ≤ " + shortNumber(held) + " where " +
         shortNumber(asked) + " was asked for, and a flatter warp tells less; with it v would be " +
         shortNumber(visibility) + ".";
}

// Why an exponential cannot be stored in `format`; empty where it can.
inline std::string exponentialRefusal(std::string_view id, StorageFormat format) {
  if (!isNormalised(format)) return {};
  return std::string(id) + " stores exponentials of depth over many decades, which " +
         std::string(nameOf(format)) + " with its even steps cannot hold; use half or float";
}

}  // namespace umbra

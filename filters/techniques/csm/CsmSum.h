// The sum that reconstructs a visibility from Fourier coefficients (Annen et al. 2007, eq. 13).
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "filters/techniques/csm/Csm.h"
#include "filters/techniques/csm/Waves.h"

namespace umbra::csm {

// Channels are S01 C01 S02 C02 …; `record` takes the steps.
template <class Record>
double sumOfTerms(const Csm& csm, const FourierSeries& fourier, std::span<const double> channels,
                  double receiver, const Record& record) {
  const bool offset = csm.values.mode == Mode::Offset;
  record("z_r", "receiver's depth, biased", "", receiver);
  double d = receiver;
  if (offset) {
    record("o", "offset that lights the receiver's own depth", "", fourier.offset());
    d = record("d", "receiver moved towards the light", "z_r − o", receiver - fourier.offset());
  }
  double sum = 0.5;
  Waves waves(d);
  for (int k = 1; k <= csm.values.terms; ++k, waves.next()) {
    const double term = fourier.coefficient(k) *
                        (waves.cosine() * channels[2 * k - 2] - waves.sine() * channels[2 * k - 1]);
    record.numbered(k)("term", "of frequency (2k − 1)/2", "2(a/c)(cos(c d) S − sin(c d) C)", term);
    sum += term;
  }
  record("f", "sum of the series", "½ + Σ terms", sum);
  if (!offset) sum = record("2f", "scaled, as the series is ½ on the receiver", "2 f", 2.0 * sum);
  return record("v", "visibility", "clamp to [0, 1]", std::clamp(sum, 0.0, 1.0));
}

}  // namespace umbra::csm

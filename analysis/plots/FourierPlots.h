// The truncated Fourier series of the shadow test, as convolution shadow maps use it, in plots.
#pragma once

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"
#include "filters/techniques/csm/Csm.h"

namespace umbra {

// The step, the series (csm::FourierSeries) as it is and attenuated, and what offset and scale mode
// make of it (Annen 2007, fig. 3). The largest swing that the clamp leaves of the mode in use is
// marked. `terms` is 1 … csm::largestTermCount. An attenuation of 0 is shown beside one of 1.
Plot fourierStepPlot(int terms, double attenuation, csm::Mode mode);
// The same with the parameters of the probe's technique csm, or with its defaults where the probe
// has no such technique.
Plot fourierStepPlot(const Probe& probe);

// Visibility of the region by csm with 1, 2, 4, 8 and 16 terms and as many as the probe's technique
// has, in its mode, over the receiver's depth, beside the exact one.
Plot fourierTermsPlot(const Probe& probe);

}  // namespace umbra

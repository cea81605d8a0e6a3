// Why a probed pixel is as bright as a technique makes it.
#pragma once

#include <string>

#include "analysis/probe/Probe.h"
#include "filters/core/technique/Trace.h"

namespace umbra {

// The technique's chain for the probe's read and receiver. In a seam between cascades that of the
// heavier part: its last value is then that part's visibility and not the mix.
Trace explain(const Probe& probe, const TechniqueResult& result);

// The sentence, then a line for every step: symbol, value, formula and meaning, aligned; the step
// that goes wrong begins with "→". For people, and for pasting.
std::string traceText(const Trace& trace);

}  // namespace umbra

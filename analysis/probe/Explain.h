// Why a probed pixel is as bright as a technique makes it.
#pragma once

#include <string>

#include "analysis/probe/Probe.h"
#include "filters/core/technique/Trace.h"

namespace umbra {

// The technique's chain of steps for the probe's read and receiver. In a seam between cascades it
// is that of the heavier part: its last value is then that part's visibility and not the mix.
Trace explain(const Probe& probe, const TechniqueResult& result);

// One sentence, then a line for every step: symbol, value, formula and meaning, aligned. The step
// that goes wrong begins with "→". The text is for people to read and paste.
std::string traceText(const Trace& trace);

}  // namespace umbra

// Errors on surfaces as JSON and as text.
#pragma once

#include <string>
#include <vector>

#include "analysis/surfaces/SurfaceErrors.h"
#include "app/output/Output.h"
#include "app/reports/Reports.h"

namespace umbra {

// {"area", "shadowedArea", "bleedingArea", "meanBleeding", "worst", "faces", "edge", "visibleFrom",
// "objects"}: see SurfaceSums; "edge" is in texels, and "visibleFrom" the error from which on light
// counts as bleeding. "worst" is null where nothing bleeds visibly. Each object has its "name" and
// the first six.
Json surfacesToJson(const SurfaceSummary& summary);

// A table of the techniques that have them; "" where none has.
std::string surfacesText(const std::vector<MetricsRow>& rows);

}  // namespace umbra

// A comparison as files and as text.
#pragma once

#include <string>
#include <vector>

#include "app/output/Output.h"
#include "app/reports/Reports.h"

namespace umbra {

// compare.json, which is `object` of compareToJson, and compare.csv: one row per technique, the
// numbers of the JSON with those of its cost; other nested ones are in the JSON alone.
void writeCompare(OutputFolder& folder, const Json& object);

// For people.
std::string compareText(const std::vector<MetricsRow>& rows);

}  // namespace umbra

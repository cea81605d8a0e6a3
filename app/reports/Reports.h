// Results as JSON, with the names of fields that other programs rely on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cost/TechniqueCost.h"
#include "analysis/errors/BleedReduction.h"
#include "analysis/errors/ErrorDecomposition.h"
#include "analysis/errors/Metrics.h"
#include "analysis/probe/Probe.h"
#include "analysis/surfaces/SurfaceErrors.h"
#include "app/output/Output.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// All parameters by name.
Json parametersOf(const Technique& technique);

// {"name", "width", "height"}.
Json sourceToJson(const std::string& name, const DepthMap& map);

// The same of a depth file, with "origin": the first texel's coordinates in the file's own count.
Json sourceToJson(const std::string& name, const DepthFile& file);

// What probeToJson writes beside the probe itself, and how finely.
struct ProbeJsonDetail {
  std::string sourceName;
  int bins = 60;    // of the histogram of depths
  int samples = 0;  // of the curves; 0 leaves them out
};
// "umbrascope-probe/1". Statistics that are infinite are null. The darkening of a smallest
// reduction is the largest on receivers at the region's own depths.
Json probeToJson(const Probe& probe, const DepthMap& map, const ProbeJsonDetail& detail);

// Turns a probe of a depth file's map, as probeToJson wrote it, to the file's own count of texels,
// and adds the receiver's depth as "receiverWorld" and, at the region's texel, "receiverFile".
void countAsFile(Json& object, const DepthFile& file);

// Adds to compareToJson of a depth file's map the "source", and the receiver's depth as "receiver",
// "receiverWorld" and, where one value of the file is the same depth everywhere, "receiverFile".
void addReceiver(Json& object, const std::string& sourceName, const DepthFile& file,
                 double receiver);

// Adds to each technique of probeToJson its "trace": {"steps": [{"symbol", "meaning", "formula",
// "value"}], "cause", "step", "sentence", "shares": [{"cause", "step", "amount"}]}. Steps count
// from 0; that of no cause is null. The shares sum to the error, in a seam that of the heavier
// part.
void addTraces(Json& object, const Probe& probe);

// Adds to probeToJson the ray-traced visibility as "raytraced", and as "errorAgainst" which truth
// the techniques' errors are against: with `replaces` it, else "pcf".
void addRayTraced(Json& object, double visibility, bool replaces);

struct MetricsRow {
  std::string technique;
  Metrics metrics;
  std::optional<BleedReduction> reduction;  // of techniques that have the parameter
  std::optional<ErrorSums> decomposition;   // of the mean signed error, where asked for
  std::optional<SurfaceSummary> surfaces;   // where asked for
  // Beside the parts of a decomposition against rays: the mean error of the map itself.
  std::optional<double> mapError;
  std::size_t pane = 0;               // of a session that compares, from 1; 0 is no pane
  Json differences = Json::object();  // a pane's settings that differ from another's
  std::optional<TechniqueCost> cost;  // where a frame was drawn
};
// How tables for people name a technique's row: "vsm", or of a pane, which counts from 1, "vsm,
// pane 2: kernel.radius 12".
std::string rowName(std::string_view technique, std::size_t pane, const Json& differences);
inline std::string nameOf(const MetricsRow& row) {
  return rowName(row.technique, row.pane, row.differences);
}

// "umbrascope-compare/1". The darkening of a smallest reduction is a mean, as that of the metrics.
// The parts of a decomposition are means over all samples and add up to its "error"; against rays
// "map" is one of them.
// "cost" has the milliseconds of bake and shade, and the bytes per texel of the map, stored by the
// method and used by the program. A pane's row has its number as "pane" and what differs from other
// panes as "settings". "reference" names the truth: "pcf" or "raytraced".
Json compareToJson(const std::vector<MetricsRow>& rows, std::string_view reference = "pcf");

// The entry of one technique or scene in its catalogue.
Json techniqueToJson(const Technique& technique);
Json sceneToJson(const SceneInfo& scene);

}  // namespace umbra

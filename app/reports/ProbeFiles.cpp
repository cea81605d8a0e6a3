#include "app/reports/ProbeFiles.h"

#include <iterator>
#include <nlohmann/json.hpp>

#include "analysis/plots/ExplainingPlots.h"
#include "analysis/plots/ProbePlots.h"
#include "analysis/probe/Explain.h"
#include "app/output/Cancellation.h"
#include "app/output/PlotFiles.h"
#include "app/output/Table.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Text.h"

namespace umbra {

void writeProbe(OutputFolder& folder, Display& display, const Probe& probe, const Json& json,
                std::string_view selected, int bins, std::vector<Plot> more) {
  writeTextAtomically(folder.file("probe.json"), toText(json));
  std::vector<Plot> plots{curvesPlot(probe, selected), histogramPlot(probe, bins), cdfPlot(probe)};
  plots.insert(plots.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
  writePlots(folder, display, plots);
}

std::vector<Plot> explainingPlotsOf(const ProbeRequest& request, const Probe& probe,
                                    const Session& session) {
  const SceneSource& source = session.source;
  ExplainingInput input{request, probe, session.technique, {}};
  if (source.kind == SourceKind::Catalogue)
    input.planes = planeDepthsOf(source.name, source.parameters);
  std::vector<Plot> plots;
  for (const ExplainingPlot& each : explainingPlots())
    if (auto plot = explainingPlot(each.name, input, throwIfCancelled))
      plots.push_back(std::move(*plot));
  return plots;
}

std::string probeText(const Probe& probe, const DepthFile* file) {
  const Region& region = probe.region;
  const RegionStatistics& s = probe.statistics;
  const int originX = file ? file->originX : 0, originY = file ? file->originY : 0;
  std::string text = "region    texel " + std::to_string(region.x + originX) + "," +
                     std::to_string(region.y + originY) + ", " + describe(region.kernel) + ", " +
                     std::to_string(region.texels.size()) + " taps\n";
  text += "depths    mean " + shortNumber(s.mean) + ", variance " + shortNumber(s.variance) +
          ", min " + shortNumber(s.min) + ", max " + shortNumber(s.max) + ", beta " +
          shortNumber(s.beta) + "\n";
  text += "receiver  " + shortNumber(probe.receiver);
  if (file)
    text += ", " + shortNumber(file->scale.worldOf(probe.receiver)) + " world, " +
            shortNumber(file->scale.fileOf(probe.receiver, region.x, region.y)) + " in the file";
  text += "\n";
  text += "reference " + shortNumber(probe.reference) + "\n\n";
  std::vector<TableRow> rows{{"TECHNIQUE", "VISIBILITY", "ERROR"}};
  bool gpu = false;
  for (const TechniqueResult& result : probe.techniques) {
    TableRow row{std::string(result.technique->info().id), shortNumber(result.visibility),
                 shortNumber(result.error)};
    if (result.gpu) {
      gpu = true;
      row.push_back(shortNumber(*result.gpu));
    }
    rows.push_back(row);
  }
  if (gpu) rows.front().push_back("GPU");
  return text + tableText(rows);
}

std::string tracesText(const Probe& probe) {
  std::string text;
  for (const TechniqueResult& result : probe.techniques)
    text +=
        "\n" + std::string(result.technique->info().id) + "\n" + traceText(explain(probe, result));
  return text;
}

}  // namespace umbra

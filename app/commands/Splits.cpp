#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/plots/SplitPlots.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/OptionValues.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/PlotFiles.h"
#include "app/reports/Reports.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/Lloyd.h"

namespace umbra {
namespace {

constexpr int mostIterations = 100000;

struct Splits {
  int layers = 1;
  LloydResult result;
  Histogram histogram;  // of the samples, by weight; empty where none has any
};

struct SplitsCommand {
  explicit SplitsCommand(OptionParser& command);

  void run() const;
  DepthMap depthMap(const Session& session) const;
  int layerCount(const Session& session) const;
  bool uniform() const;
  Splits place(const DepthMap& map, int layers) const;

  SessionOptions options;
  std::optional<std::string> layers, placement, iterations, bins, folder;
  bool json = false;
  TechniqueCatalogue catalogue = allTechniques();
};

SplitsCommand::SplitsCommand(OptionParser& command) {
  const std::string group = "Splits";
  const auto add = [&](const std::string& name, auto& value, const std::string& type,
                       const std::string& text) {
    command.add(name, value, {group, type, text});
  };
  add("--layers", layers, "N", "Layers, one more than splits (default lvsm.layers)");
  add("--placement", placement, "NAME", "uniform or lloyd (default)");
  add("--iterations", iterations, "K", "Stop after K iterations; else when nothing moves");
  add("--bins", bins, "N", "Bins of the histogram (default 60)");
  add("-o,--output", folder, "DIR", "Write splits.json and the plots as PNG, SVG, PDF and CSV");
  command.addFlag("--json", json, {group, "", "Print one JSON object"});
  options.addTo(command);
}

bool SplitsCommand::uniform() const {
  if (!placement || *placement == "lloyd") return false;
  if (*placement == "uniform") return true;
  throw Error(ErrorKind::BadCommandLine,
              "--placement: '" + *placement + "' is not right, it takes uniform or lloyd");
}

int SplitsCommand::layerCount(const Session& session) const {
  const std::unique_ptr<Technique> technique = techniqueOf(session, catalogue, "lvsm");
  const std::vector<Parameter> parameters = technique->parameters();
  const Parameter& row = parameterNamed(parameters, "layers", "lvsm.layers");
  return layers ? integerFrom(*layers, "--layers", int(row.low), int(row.high))
                : std::get<int>(row.get());
}

DepthMap SplitsCommand::depthMap(const Session& session) const {
  if (session.source.kind == SourceKind::DepthFile) return loadedDepth(session.source).map;
  checkGpuFormat(session);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  frame->render(*catalogue.make("hard"), ViewMode::Shaded);
  return frame->depthMap();
}

Splits SplitsCommand::place(const DepthMap& map, int count) const {
  Splits splits{.layers = count};
  const std::vector<WeightedSample> samples = secondOccluderSamples(map);
  LloydOptions lloyd{.splits = count - 1, .maxIterations = mostIterations};
  if (iterations) lloyd.maxIterations = integerFrom(*iterations, "--iterations", 1, mostIterations);
  // The first iteration's cost is that of the uniform start; its move is not wanted.
  if (uniform()) lloyd.maxIterations = 1;
  splits.result = relax(samples, lloyd);
  if (uniform()) {
    splits.result.iterations = splits.result.teleports = 0;
    for (int k = 1; k < count; ++k) splits.result.splits[k - 1] = double(k) / count;
  }
  std::vector<double> values, weights;
  for (const WeightedSample& sample : samples) {
    values.push_back(sample.value);
    weights.push_back(sample.weight);
  }
  splits.histogram =
      histogramOf(values, weights, bins ? integerFrom(*bins, "--bins", 1, 100000) : 60);
  return splits;
}

Json splitsToJson(const Splits& splits) {
  return {
      {"format", "umbrascope-splits/1"},
      {"layers", splits.layers},
      {"splits", splits.result.splits},
      {"cost", splits.result.cost},
      {"iterations", splits.result.iterations},
      {"teleports", splits.result.teleports},
      {"histogram", {{"edges", splits.histogram.edges}, {"weights", splits.histogram.weights}}}};
}

std::string splitsText(const Splits& splits) {
  const LloydResult& result = splits.result;
  std::string text = "layers     " + std::to_string(splits.layers) + "\nsplits    ";
  for (double split : result.splits) text += " " + shortNumber(split);
  if (!result.cost.empty())
    text += "\ncost       " + shortNumber(result.cost.front()) + " at the start, " +
            shortNumber(result.cost.back()) + " at the end";
  return text + "\niterations " + std::to_string(result.iterations) + ", teleports " +
         std::to_string(result.teleports) + "\n";
}

void SplitsCommand::run() const {
  if (json && folder)
    throw Error(ErrorKind::BadCommandLine, "--json: excludes -o, give one of them");
  if (folder) checkWritable(std::filesystem::path(*folder) / "splits.json");
  const Session session = options.session(catalogue);
  const int count = layerCount(session);
  uniform();
  const DepthMap map = depthMap(session);
  throwIfCancelled();
  const Splits splits = place(map, count);
  throwIfCancelled();
  if (json) return printJson(splitsToJson(splits));
  if (!folder) return print(splitsText(splits));
  OutputFolder files(*folder);
  writeTextAtomically(files.file("splits.json"), toText(splitsToJson(splits)));
  const Plot plots[] = {splitsPlot(splits.histogram, splits.result.splits),
                        costPlot(splits.result.cost)};
  writePlots(files, *loadDisplay(), plots);
  files.finish();
}

}  // namespace

Command addSplits(OptionParser& program) {
  OptionParser command = program.addCommand(
      "splits", "Place the splits of layered variance shadow maps", commandsGroup);
  const auto splits = std::make_shared<SplitsCommand>(command);
  return {command, [splits] { splits->run(); }};
}

}  // namespace umbra

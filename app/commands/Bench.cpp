#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/bench/AnalysisTimes.h"
#include "app/bench/BenchReport.h"
#include "app/bench/FrameRounds.h"
#include "app/bench/GoalTable.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/OptionValues.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr int mostRounds = 1000;
// A table of many cases comes to an end within minutes.
constexpr RoundLimits goalLimits{.least = 6, .most = 8};
constexpr double goalHalfAngle = 40.0;  // degrees

struct BenchCommand {
  explicit BenchCommand(OptionParser& command);

  void run() const;
  bool checksGoals() const { return goals || !goalTexts.empty(); }
  Workspace workspace() const;
  std::vector<CostGoal> goalsAsked() const;
  std::vector<Drawing> drawings(const Workspace& workspace) const;
  RoundLimits limits() const;
  std::optional<CostClock> costClock() const;
  Light ownLightOf(const Scene& scene) const;
  BenchReport measure(const Workspace& workspace, const std::vector<Drawing>& cases,
                      const std::vector<CostGoal>& asked, Display& display) const;

  SessionOptions options;
  std::optional<std::string> folder, rounds, clock;
  std::vector<std::string> goalTexts;
  bool json = false, goals = false;
  TechniqueCatalogue catalogue = allTechniques();
};

BenchCommand::BenchCommand(OptionParser& command) {
  const std::string group = "Bench";
  command.add("--rounds", rounds,
              {group, "N",
               "Measure so many rounds, 1 to 1000; else until the medians are known to 2 %, at "
               "least 6 and at most 16 rounds"});
  command.add("--clock", clock,
              {group, "processor|gpu",
               "What counts: processor time of all threads (the default where the processor "
               "draws), or the GPU's timers (the default elsewhere)"});
  command.addFlag("--goals", goals,
                  {group, "",
                   "Measure the ratios that have a goal, on the scene car with a spot light of 40 "
                   "degrees and a box kernel of radius 2 unless options say otherwise; the exit "
                   "status is 1 where one is "
                   "missed. --technique keeps those goals that compare these techniques alone"});
  command.addRepeatable(
      "--goal", goalTexts,
      {group, "TEXT", "Like --goals, only those whose names contain the text; repeatable"});
  command.add("-o,--output", folder, {group, "DIR", "Write bench.json and bench.csv"});
  command.addFlag("--json", json, {group, "", "Print one JSON object"});
  command.setFooter(
      "Draws each technique in turns with the same scene without shadows and with VTK's own\n"
      "vtkShadowMapPass, whose shadows are never blurred. Each has two figures: the frame after "
      "the\n"
      "camera has moved, which bakes nothing, and after the light has moved, which bakes all.\n"
      "Times on a busy machine spread; ratios within one run hardly do. A GPU's timers also count\n"
      "what the GPU waits for the program between two commands.");
  options.addTo(command);
}

Workspace BenchCommand::workspace() const {
  if (!checksGoals() || options.namesSession()) return options.workspace(catalogue);
  Workspace base;
  base.shared = goalSession();
  return options.over(std::move(base), catalogue);
}

std::vector<CostGoal> BenchCommand::goalsAsked() const {
  if (!checksGoals()) return {};
  std::vector<std::string> ids;
  if (options.namesTechniques()) {
    const TechniqueChoice choice = options.techniques(catalogue, {});
    if (!choice.all) ids = choice.ids;
  }
  return goalsNamed(goalTexts, ids);
}

// The panes of a session that compares, unless techniques are named; else the session's technique.
std::vector<Drawing> BenchCommand::drawings(const Workspace& workspace) const {
  if (!options.namesTechniques() && workspace.comparison.mode != ComparisonMode::Single)
    return drawingsOfPanes(workspace, catalogue);
  const Session session = sessionOf(workspace);
  return drawingsOf(session, makeTechniques(session, catalogue,
                                            options.techniques(catalogue, {{session.technique}})));
}

RoundLimits BenchCommand::limits() const {
  if (!rounds) return checksGoals() ? goalLimits : RoundLimits();
  const int count = integerFrom(*rounds, "--rounds", 1, mostRounds);
  return {.least = count, .most = count};
}

std::optional<CostClock> BenchCommand::costClock() const {
  if (!clock) return {};
  if (*clock == "processor") return CostClock::Processor;
  if (*clock == "gpu") return CostClock::Gpu;
  throw Error(ErrorKind::BadCommandLine,
              "--clock: '" + clipped(*clock) + "' is not right, it takes processor or gpu");
}

// The goals were set beside a spot light. Beside a sun, the same scene costs less without shadows,
// and what shadows add counts for more.
Light BenchCommand::ownLightOf(const Scene& scene) const {
  Light light = scene.light;
  if (checksGoals()) {
    light.kind = LightKind::Spot;
    light.halfAngle = goalHalfAngle;
  }
  return light;
}

BenchReport BenchCommand::measure(const Workspace& workspace, const std::vector<Drawing>& cases,
                                  const std::vector<CostGoal>& asked, Display& display) const {
  const Session session = sessionOf(workspace);
  const auto scene = options.scene(session.source);
  const BenchView view{scene, session.light.value_or(ownLightOf(*scene)),
                       session.camera.value_or(scene->camera), session.width, session.height};
  BenchReport report{.scene = shortNameOf(session.source),
                     .light = view.light.kind,
                     .width = session.width,
                     .height = session.height,
                     .cases = cases,
                     .frames = {},
                     .analysis = {},
                     .ratios = {}};
  if (!cases.empty())
    report.frames = measureFrames(display, {view, session.frame.map.size, cases, costClock(),
                                            limits(), [] { throwIfCancelled(); }});
  measureAnalysis(display, session, catalogue, scene, asked, report.analysis, throwIfCancelled);
  CostSamples all = report.frames.samples;
  all.add(report.analysis);
  for (const CostGoal& goal : asked) report.ratios.push_back(ratioOf(all, goal));
  if (asked.empty())
    for (const Drawing& drawing : cases)
      for (const CostRatio& ratio : ratiosOfFrames(all, drawing.name))
        report.ratios.push_back(ratio);
  return report;
}

void BenchCommand::run() const {
  if (json && folder)
    throw Error(ErrorKind::BadCommandLine, "--json: excludes -o, give one of them");
  if (folder) checkWritable(std::filesystem::path(*folder) / "bench.json");
  limits();
  costClock();
  const std::vector<CostGoal> asked = goalsAsked();
  const Workspace workspace = this->workspace();
  const Session session = sessionOf(workspace);
  if (session.source.kind == SourceKind::DepthFile)
    throw Error(ErrorKind::BadCommandLine,
                "--depth: has no frames to measure; give --scene NAME or a mesh file");
  checkGpuFormat(session);
  const std::vector<Drawing> cases =
      checksGoals() ? casesOf(asked, session, catalogue) : drawings(workspace);
  for (const Drawing& drawing : cases) checkGpuFormat(drawing.session);
  const std::unique_ptr<Display> display = loadDisplay();
  const BenchReport report = measure(workspace, cases, asked, *display);
  throwIfCancelled();
  if (json) {
    printJson(benchToJson(report));
  } else if (folder) {
    OutputFolder files(*folder);
    writeBench(files, report);
    files.finish();
  } else {
    print(benchText(report));
  }
  const std::vector<std::string> missed = missedIn(report.ratios);
  if (!missed.empty())
    throw Error(ErrorKind::WorkFailed, "--goals: " + std::to_string(missed.size()) + " of " +
                                           std::to_string(report.ratios.size()) +
                                           " are missed: " + joined(missed, "; "));
}

}  // namespace

Command addBench(OptionParser& program) {
  OptionParser command = program.addCommand(
      "bench", "Measure the cost of every pass, ours and VTK's own shadow pass", commandsGroup);
  const auto bench = std::make_shared<BenchCommand>(command);
  return {command, [bench] { bench->run(); }};
}

}  // namespace umbra

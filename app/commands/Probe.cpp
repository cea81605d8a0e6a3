#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/frame/FrameReads.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/Drawings.h"
#include "app/frames/NamedProbes.h"
#include "app/frames/PaneProbes.h"
#include "app/frames/RayTracedFrame.h"
#include "app/frames/SceneProbe.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/OptionValues.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/reports/ProbeFiles.h"
#include "app/reports/Reports.h"
#include "datasets/session/DepthReading.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

struct ProbeCommand {
  explicit ProbeCommand(OptionParser& command);

  void run() const;
  void probeDepthMap(Workspace workspace) const;
  void probePixel(const Workspace& workspace) const;
  // What is probed: the session's techniques, and the panes of one that compares.
  struct Subject {
    Session session;
    std::vector<std::shared_ptr<Technique>> techniques;
    std::vector<Drawing> panes;
  };
  void probeSaved(const Subject& subject, const std::vector<NamedProbe>& saved,
                  const std::shared_ptr<const Scene>& scene, HeadlessFrame& frame,
                  Display& display) const;
  std::vector<NamedProbe> savedOnes(const Session& session) const;
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session) const;
  // The panes of a session that compares, unless techniques are named.
  std::vector<Drawing> panes(const Workspace& workspace) const;
  bool rayTraced() const;
  bool isTable() const { return named && *named == "all"; }
  struct Taken {
    ProbeRequest request;
    Probe probe;
    Json json;
    std::optional<double> truth;                 // by rays, where errors are against it
    std::shared_ptr<const FrameSnapshot> frame;  // whose maps the request refers to, of a scene
    std::vector<PaneProbe> panes{};              // of a session that compares
    const DepthFile* file = nullptr;             // whose map was probed, of a depth file
  };
  static TakenProbe justTheProbe(Taken taken) {
    return {std::move(taken.probe), std::move(taken.json)};
  }
  static void addPanes(Taken& taken, std::vector<PaneProbe> panes);
  Taken takeTexel(const Session& session, const DepthFile& file,
                  const std::vector<std::shared_ptr<Technique>>& chosen, Pixel at,
                  double depth) const;
  Taken describe(SceneProbe probe, HeadlessFrame& frame, const Session& session) const;
  void finishTable(const Json& source, const std::vector<NamedResult>& results) const;
  // Writes or prints what was asked for.
  void finish(const Taken& taken, const Session& session, Display* display) const;

  SessionOptions options;
  std::optional<std::string> texel, pixel, named, receiver, bins, samples, folder, reference;
  bool json = false, trace = false;
  TechniqueCatalogue catalogue = allTechniques();
};

ProbeCommand::ProbeCommand(OptionParser& command) {
  const std::string group = "Probe";
  const auto add = [&](const std::string& name, auto& value, const std::string& type,
                       const std::string& text) {
    command.add(name, value, {group, type, text});
  };
  add("--texel", texel, "X,Y",
      "Of a depth map: the region's centre in the file's own count, as viewers show it, y down");
  add("--receiver", receiver, "Z",
      "Receiver's linear depth, 0 to 1; of a depth map, which needs one, also a distance such as "
      "6w "
      "or a value of the file such as 0.97f");
  add("--pixel", pixel, "X,Y|worst",
      "Of a scene: y down, from 0, or where vsm, or else the first bound, bleeds most");
  add("--named", named, "NAME|all", "A probe that the session keeps, or all of them as one table");
  add("--bins", bins, "N", "Bins of the histogram (default 60)");
  add("--samples", samples, "N", "Also every technique's curve at N depths from 0 to 1");
  add("-o,--output", folder, "DIR", "Write probe.json and the plots as PNG, SVG, PDF and CSV");
  add("--reference", reference, "pcf|raytraced",
      "Of a scene: what the errors are against, exact percentage-closer filtering of the map (the "
      "default), or of a map of unlimited resolution, by rays through every texel");
  command.addFlag("--json", json, {group, "", "Print one JSON object"});
  command.addFlag(
      "--trace", trace,
      {group, "", "Also how each technique comes to its visibility, and which step goes wrong"});
  command.setFooter(
      "A session that compares is also probed in every pane, with the pane's own technique and\n"
      "settings, unless --technique names techniques. The table of all techniques has the "
      "settings\n"
      "of the active pane.");
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> ProbeCommand::techniques(const Session& session) const {
  return makeTechniques(session, catalogue,
                        options.techniques(catalogue, everyTechnique(catalogue)));
}

std::vector<Drawing> ProbeCommand::panes(const Workspace& workspace) const {
  if (options.namesTechniques() || workspace.comparison.mode == ComparisonMode::Single) return {};
  return panesOf(workspace, catalogue);
}

void ProbeCommand::addPanes(Taken& taken, std::vector<PaneProbe> panes) {
  if (panes.empty()) return;
  taken.panes = std::move(panes);
  taken.json["panes"] = panesToJson(taken.panes);
}

int binsOf(const std::optional<std::string>& text) {
  return text ? integerFrom(*text, "--bins", 1, 100000) : 60;
}

int samplesOf(const std::optional<std::string>& text) {
  return text ? integerFrom(*text, "--samples", 2, 1000000) : 0;
}

bool ProbeCommand::rayTraced() const {
  return reference && rayTracedFrom(*reference, "--reference");
}

void ProbeCommand::run() const {
  if (json && folder)
    throw Error(ErrorKind::BadCommandLine, "--json: excludes -o, give one of them");
  if (rayTraced() && trace)
    throw Error(ErrorKind::BadCommandLine,
                "--trace: takes the error against pcf apart, leave --reference raytraced out");
  if (named && (pixel || texel))
    throw Error(ErrorKind::BadCommandLine, std::string(pixel ? "--pixel" : "--texel") +
                                               ": excludes --named, give one of them");
  binsOf(bins);
  samplesOf(samples);
  Workspace workspace = options.workspace(catalogue);
  Session& session = workspace.shared;
  const bool isScene = session.source.kind != SourceKind::DepthFile;
  // A depth map's receiver may be told in measures that only the file knows.
  if (receiver && isScene) session.receiver = numberFrom(*receiver, "--receiver", {0.0, 1.0});
  savedOnes(session);  // refuses a name that there is not before anything is loaded
  if (folder)
    checkWritable(std::filesystem::path(*folder) / (isTable() ? "probes.json" : "probe.json"));
  if (session.source.kind == SourceKind::DepthFile)
    probeDepthMap(workspace);
  else
    probePixel(workspace);
}

// What --named chooses; or the saved one that the session's probe is at, unless another is asked
// for.
std::vector<NamedProbe> ProbeCommand::savedOnes(const Session& session) const {
  if (named) return chosenProbes(session, *named);
  const NamedProbe* current = probeNamed(session.probes, session.keptProbe);
  if (!current || pixel || texel) return {};
  NamedProbe probe = *current;
  probe.receiver = session.receiver;
  return {probe};
}

ProbeCommand::Taken ProbeCommand::takeTexel(const Session& session, const DepthFile& file,
                                            const std::vector<std::shared_ptr<Technique>>& chosen,
                                            Pixel at, double depth) const {
  const DepthMap& map = file.map;
  Taken taken{{.map = map,
               .read = ReadPoint::atTexel(map, at.x, at.y),
               .kernel = session.frame.kernel,
               .format = session.frame.map.format,
               .receiver = depth},
              {},
              {}};
  for (const auto& technique : chosen) {
    technique->adapt(map);
    taken.request.techniques.push_back(technique);
  }
  taken.probe = takeProbe(taken.request);
  taken.json = probeToJson(taken.probe, map,
                           {shortNameOf(session.source), binsOf(bins), samplesOf(samples)});
  countAsFile(taken.json, file);
  taken.file = &file;
  if (trace) addTraces(taken.json, taken.probe);
  return taken;
}

void ProbeCommand::probeDepthMap(Workspace workspace) const {
  Session& shared = workspace.shared;
  if (pixel)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: goes with a scene, a depth map takes --texel X,Y");
  if (rayTraced())
    throw Error(
        ErrorKind::BadCommandLine,
        "--reference: a depth map has no surfaces that rays could meet; raytraced goes with "
        "a scene");
  std::vector<NamedProbe> places = savedOnes(shared);
  if (places.empty() && !texel && !shared.probe)
    throw Error(ErrorKind::BadCommandLine, "--texel: is missing, give --texel X,Y");
  if (places.empty() && !receiver && !shared.receiver)
    throw Error(ErrorKind::BadCommandLine, "--receiver: is missing, give --receiver Z");
  std::optional<std::pair<int, int>> asked;
  if (texel) asked = texelFrom(*texel, "--texel");
  if (!options.namesFormat() && !options.namesSession()) chooseFormatFor(shared);
  Session session = sessionOf(workspace);
  session.frame = readSettingsOf(session);
  const auto chosen = techniques(session);
  const std::vector<Drawing> compared = panes(workspace);
  const DepthFile file = loadedDepth(session.source);
  const DepthMap& map = file.map;
  if (asked) shared.probe = {asked->first - file.originX, asked->second - file.originY};
  if (places.empty()) places.push_back({"", {}, shared.probe, shared.receiver});
  std::vector<NamedResult> results;
  for (const NamedProbe& place : places) {
    const auto [x, y] = *place.texel;
    NamedResult& result = results.emplace_back(NamedResult{place, {}, {}, {}, {}});
    result.saved.texel = {x + file.originX, y + file.originY};
    if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) {
      const bool fromZero = file.originX == 0 && file.originY == 0;
      result.reason =
          std::to_string(result.saved.texel->x) + "," + std::to_string(result.saved.texel->y) +
          " is outside the map of " + std::to_string(map.width()) + "x" +
          std::to_string(map.height()) + " texels, which count from " +
          (fromZero ? "0" : std::to_string(file.originX) + "," + std::to_string(file.originY));
      if (!isTable())
        throw Error(ErrorKind::BadCommandLine, (named ? "--named: " : "--texel: ") + result.reason);
      continue;
    }
    const double depth = receiver ? receiverFrom(*receiver, "--receiver", file, x, y)
                                  : place.receiver.value_or(NamedProbe::depthOnFile);
    Taken taken = takeTexel(session, file, chosen, *place.texel, depth);
    std::vector<PaneProbe> ofPanes;
    for (const Drawing& pane : compared)
      ofPanes.push_back(probePane(pane, [&] {
        return justTheProbe(takeTexel(pane.session, file, {pane.technique}, *place.texel, depth));
      }));
    addPanes(taken, std::move(ofPanes));
    if (named) taken.json["name"] = place.name;
    if (!isTable()) return finish(taken, session, nullptr);
    result.probe = std::move(taken.probe);
    result.json = std::move(taken.json);
    result.panes = std::move(taken.panes);
  }
  finishTable(sourceToJson(shortNameOf(session.source), file), results);
}

void ProbeCommand::probePixel(const Workspace& workspace) const {
  Subject subject{sessionOf(workspace), {}, {}};
  const Session& session = subject.session;
  if (texel)
    throw Error(ErrorKind::BadCommandLine, "--texel: goes with --depth, a scene takes --pixel X,Y");
  const std::vector<NamedProbe> saved = savedOnes(session);
  if (saved.empty() && !pixel && !session.probe)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: is missing, give --pixel X,Y or --pixel worst");
  std::optional<Pixel> place = session.probe;
  if (pixel) place = *pixel == "worst" ? std::nullopt : std::optional(pixelFrom(*pixel, "--pixel"));
  checkGpuFormat(session);
  subject.techniques = techniques(session);
  subject.panes = panes(workspace);
  for (Drawing& pane : subject.panes)
    if (pane.refusal.empty()) pane.refusal = whyNoGpuFormat(pane.session);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  if (!saved.empty()) return probeSaved(subject, saved, scene, *frame, *display);
  if (!place) place = worstBleeding(*frame, *suspectOf(subject.techniques));
  Taken taken = describe(probeScene(*frame, session, subject.techniques, *place), *frame, session);
  std::vector<PaneProbe> ofPanes;
  for (const Drawing& pane : subject.panes)
    ofPanes.push_back(probePane(pane, [&] {
      frame->show(scene, pane.session);
      return justTheProbe(describe(probeScene(*frame, pane.session, {pane.technique}, *place),
                                   *frame, pane.session));
    }));
  addPanes(taken, std::move(ofPanes));
  finish(taken, session, display.get());
}

void ProbeCommand::probeSaved(const Subject& subject, const std::vector<NamedProbe>& saved,
                              const std::shared_ptr<const Scene>& scene, HeadlessFrame& frame,
                              Display& display) const {
  const Session& session = subject.session;
  const auto byHand = receiver ? session.receiver : std::optional<double>();
  auto probes = umbra::probeSaved(frame, session, subject.techniques, saved, byHand);
  const Json source = sourceToJson(shortNameOf(session.source), frame.depthMap());
  std::vector<std::optional<Taken>> taken(saved.size());
  for (std::size_t i = 0; i < saved.size(); ++i) {
    if (!probes[i].probe && !isTable())
      throw Error(ErrorKind::BadCommandLine,
                  (named ? "--named: " : "keptProbe: ") + saved[i].name + ": " + probes[i].reason);
    if (!probes[i].probe) continue;
    taken[i].emplace(describe(std::move(*probes[i].probe), frame, session));
    if (named) taken[i]->json["name"] = saved[i].name;
  }
  // The panes come last, one after the other: each of them draws another frame.
  std::vector<std::vector<PaneProbe>> ofPanes(saved.size());
  for (const Drawing& pane : subject.panes) {
    std::vector<SavedSceneProbe> own(saved.size());
    if (pane.refusal.empty()) {
      frame.show(scene, pane.session);
      own = umbra::probeSaved(frame, pane.session, {pane.technique}, saved, byHand);
    }
    for (std::size_t i = 0; i < saved.size(); ++i)
      ofPanes[i].push_back(probePane(pane, [&] {
        if (!own[i].probe) throw Error(ErrorKind::BadCommandLine, own[i].reason);
        return justTheProbe(describe(std::move(*own[i].probe), frame, pane.session));
      }));
  }
  for (std::size_t i = 0; i < saved.size(); ++i)
    if (taken[i]) addPanes(*taken[i], std::move(ofPanes[i]));
  if (!isTable()) return finish(*taken.front(), session, &display);
  std::vector<NamedResult> results;
  for (std::size_t i = 0; i < saved.size(); ++i) {
    NamedResult& result = results.emplace_back(NamedResult{saved[i], {}, {}, probes[i].reason, {}});
    if (!taken[i]) continue;
    result.probe = std::move(taken[i]->probe);
    result.json = std::move(taken[i]->json);
    result.truth = taken[i]->truth;
    result.panes = std::move(taken[i]->panes);
  }
  finishTable(source, results);
}

// Adds what was asked for beside the probe.
ProbeCommand::Taken ProbeCommand::describe(SceneProbe probe, HeadlessFrame& frame,
                                           const Session& session) const {
  // A report for people says it only where it was asked for.
  std::optional<double> rays;
  if (rayTraced() || json || folder) rays = rayTracedVisibility(frame, probe.probe);
  Json object = sceneProbeToJson(probe, frame.depthMap(), shortNameOf(session.source),
                                 session.frame.read.filter, binsOf(bins), samplesOf(samples));
  if (rays) addRayTraced(object, *rays, rayTraced());
  if (rayTraced())
    for (TechniqueResult& result : probe.probe.techniques) result.error = result.visibility - *rays;
  if (trace) addTraces(object, probe.probe);
  auto snapshot = frame.snapshot();
  ProbeRequest request = requestOf(*snapshot, probe.surface);
  request.receiver = probe.probe.receiver;
  for (const TechniqueResult& result : probe.probe.techniques)
    request.techniques.push_back(result.technique);
  return {std::move(request), std::move(probe.probe), std::move(object),
          rayTraced() ? rays : std::nullopt, std::move(snapshot)};
}

void ProbeCommand::finishTable(const Json& source, const std::vector<NamedResult>& results) const {
  const Json object = namedToJson(source, results);
  if (json) return printJson(object);
  if (!folder) {
    print(namedText(results));
    for (const NamedResult& result : results) {
      if (!result.panes.empty()) print("\n" + result.saved.name + "\n" + panesText(result.panes));
      if (trace && result.probe) print("\n" + result.saved.name + "\n" + tracesText(*result.probe));
    }
    return;
  }
  OutputFolder files(*folder);
  writeNamed(files, object, results);
  files.finish();
}

void ProbeCommand::finish(const Taken& taken, const Session& session, Display* display) const {
  const auto& [request, probe, object, truth, frame, compared, file] = taken;
  if (json) return printJson(object);
  if (!folder && truth)
    print("ray traced " + shortNumber(*truth) + ", which the errors are against\n");
  if (!folder)
    return print(probeText(probe, file) + (compared.empty() ? "" : "\n" + panesText(compared)) +
                 (trace ? tracesText(probe) : std::string()));
  OutputFolder files(*folder);
  const std::unique_ptr<Display> own = display ? nullptr : loadDisplay();
  writeProbe(files, display ? *display : *own, probe, object, session.technique, binsOf(bins),
             explainingPlotsOf(request, probe, session));
  files.finish();
}

}  // namespace

Command addProbe(OptionParser& program) {
  OptionParser command = program.addCommand(
      "probe", "Take one region apart: depths, techniques, reference", commandsGroup);
  const auto probe = std::make_shared<ProbeCommand>(command);
  return {command, [probe] { probe->run(); }};
}

}  // namespace umbra

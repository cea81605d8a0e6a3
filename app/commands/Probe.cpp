#include <memory>
#include <optional>

#include "app/FrameReads.h"
#include "app/ProbeFiles.h"
#include "app/RayTracedFrame.h"
#include "app/Reports.h"
#include "app/SceneProbe.h"
#include "app/SceneSources.h"
#include "app/TechniqueSet.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/options/OptionValues.h"
#include "app/options/SessionOptions.h"
#include "filters/core/Error.h"
#include "filters/core/Text.h"

namespace umbra {
namespace {

struct ProbeCommand {
  explicit ProbeCommand(CLI::App& command);

  void run() const;
  void probeDepthMap(Session session) const;
  void probePixel(const Session& session) const;
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session) const;
  bool rayTraced() const;
  // Writes or prints what was asked for.
  void finish(const ProbeRequest& request, const Probe& probe, const Json& json,
              const Session& session, Display* display) const;

  SessionOptions options;
  std::optional<std::string> texel, pixel, receiver, bins, samples, folder, reference;
  bool json = false, trace = false;
  TechniqueCatalogue catalogue = allTechniques();
};

ProbeCommand::ProbeCommand(CLI::App& command) {
  const std::string group = "Probe";
  const auto add = [&](const std::string& name, auto& value, const std::string& type,
                       const std::string& text) {
    command.add_option(name, value, text)->type_name(type)->group(group);
  };
  add("--texel", texel, "X,Y", "Of a depth map: the region's centre, y down, from 0");
  add("--receiver", receiver, "Z", "Receiver's depth, 0 to 1; needed with --depth");
  add("--pixel", pixel, "X,Y|worst",
      "Of a scene: y down, from 0, or where vsm, or else the first bound, bleeds most");
  add("--bins", bins, "N", "Bins of the histogram (default 60)");
  add("--samples", samples, "N", "Also every technique's curve at N depths from 0 to 1");
  add("-o,--output", folder, "DIR", "Write probe.json and the plots as PNG, SVG, PDF and CSV");
  add("--reference", reference, "pcf|raytraced",
      "Of a scene: what the errors are against, exact percentage-closer filtering of the map (the "
      "default), or of a map of unlimited resolution, by rays through every texel");
  command.add_flag("--json", json, "Print one JSON object")->group(group);
  command
      .add_flag("--trace", trace,
                "Also how each technique comes to its visibility, and which step goes wrong")
      ->group(group);
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> ProbeCommand::techniques(const Session& session) const {
  return makeTechniques(session, catalogue,
                        options.techniques(catalogue, everyTechnique(catalogue)));
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
  binsOf(bins);
  samplesOf(samples);
  if (folder) checkWritable(std::filesystem::path(*folder) / "probe.json");
  Session session = options.session(catalogue);
  if (receiver) session.receiver = numberFrom(*receiver, "--receiver", {0.0, 1.0});
  if (session.source.kind == SourceKind::DepthFile)
    probeDepthMap(session);
  else
    probePixel(session);
}

void ProbeCommand::probeDepthMap(Session session) const {
  if (pixel)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: goes with a scene, a depth map takes --texel X,Y");
  if (rayTraced())
    throw Error(
        ErrorKind::BadCommandLine,
        "--reference: a depth map has no surfaces that rays could meet; raytraced goes with "
        "a scene");
  if (texel) session.probe = pixelFrom(*texel, "--texel");
  if (!session.probe)
    throw Error(ErrorKind::BadCommandLine, "--texel: is missing, give --texel X,Y");
  if (!session.receiver)
    throw Error(ErrorKind::BadCommandLine, "--receiver: is missing, give --receiver Z");
  if (!options.namesFormat() && !options.namesSession())
    session.frame.map.format = StorageFormat::Double;
  session.frame.read.filter = ReadFilter::Point;  // of the texel
  const auto chosen = techniques(session);
  const DepthMap map = loadDepthMap(session.source);
  const auto [x, y] = *session.probe;
  if (x >= map.width() || y >= map.height())
    throw Error(ErrorKind::BadCommandLine,
                "--texel: " + std::to_string(x) + "," + std::to_string(y) +
                    " is outside the map of " + std::to_string(map.width()) + "x" +
                    std::to_string(map.height()) + " texels, which count from 0");
  ProbeRequest request{.map = map,
                       .read = ReadPoint::atTexel(map, x, y),
                       .kernel = session.frame.kernel,
                       .format = session.frame.map.format,
                       .receiver = *session.receiver};
  for (const auto& technique : chosen) {
    technique->adapt(map);
    request.techniques.push_back(technique);
  }
  const Probe probe = takeProbe(request);
  Json object =
      probeToJson(probe, map, {shortNameOf(session.source), binsOf(bins), samplesOf(samples)});
  if (trace) addTraces(object, probe);
  finish(request, probe, object, session, nullptr);
}

void ProbeCommand::probePixel(const Session& session) const {
  if (texel)
    throw Error(ErrorKind::BadCommandLine, "--texel: goes with --depth, a scene takes --pixel X,Y");
  if (!pixel && !session.probe)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: is missing, give --pixel X,Y or --pixel worst");
  std::optional<Pixel> place = session.probe;
  if (pixel) place = *pixel == "worst" ? std::nullopt : std::optional(pixelFrom(*pixel, "--pixel"));
  checkGpuFormat(session);
  const auto chosen = techniques(session);
  const std::string name = shortNameOf(session.source);
  const auto scene = std::make_shared<const Scene>(loadScene(session.source));
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  if (!place) place = worstBleeding(*frame, *suspectOf(chosen));
  SceneProbe probe = probeScene(*frame, session, chosen, *place);
  // A report for people says it only where it was asked for.
  std::optional<double> rays;
  if (rayTraced() || json || folder)
    rays = rayTracedVisibility(*frame, *scene, session.frame, probe.probe);
  Json object = sceneProbeToJson(probe, frame->depthMap(), name, session.frame.read.filter,
                                 binsOf(bins), samplesOf(samples));
  if (rays) addRayTraced(object, *rays, rayTraced());
  if (rayTraced())
    for (TechniqueResult& result : probe.probe.techniques) result.error = result.visibility - *rays;
  if (trace) addTraces(object, probe.probe);
  ProbeRequest request = requestAt(*frame, session.frame, probe.surface);
  request.receiver = probe.probe.receiver;
  request.techniques.assign(chosen.begin(), chosen.end());
  finish(request, probe.probe, object, session, display.get());
}

void ProbeCommand::finish(const ProbeRequest& request, const Probe& probe, const Json& object,
                          const Session& session, Display* display) const {
  if (json) return printJson(object);
  if (!folder && rayTraced())
    print("ray traced " + shortNumber(object["raytraced"].get<double>()) +
          ", which the errors are against\n");
  if (!folder) return print(probeText(probe) + (trace ? tracesText(probe) : std::string()));
  OutputFolder files(*folder);
  const std::unique_ptr<Display> own = display ? nullptr : loadDisplay();
  writeProbe(files, display ? *display : *own, probe, object, session.technique, binsOf(bins),
             explainingPlotsOf(request, probe, session));
  files.finish();
}

}  // namespace

Command addProbe(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("probe", "Take one region apart: depths, techniques, truth");
  const auto probe = std::make_shared<ProbeCommand>(*command);
  return {command, [probe] { probe->run(); }};
}

}  // namespace umbra

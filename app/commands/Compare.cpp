#include <memory>
#include <optional>

#include "analysis/errors/CompareMap.h"
#include "analysis/plots/CostPlots.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/Drawings.h"
#include "app/frames/FrameDecomposition.h"
#include "app/frames/RayTracedFrame.h"
#include "app/frames/SceneCompare.h"
#include "app/frames/SurfaceCompare.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/OptionValues.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/PlotFiles.h"
#include "app/reports/CompareFiles.h"
#include "app/reports/Reports.h"
#include "datasets/session/DepthReading.h"
#include "datasets/session/file/SessionInExr.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct CompareCommand {
  explicit CompareCommand(OptionParser& command);

  void run() const;
  void compareMap(Workspace workspace) const;
  void compareScene(const Workspace& workspace) const;
  std::vector<Drawing> drawings(const Workspace& workspace) const;
  bool rayTraced() const;
  std::optional<SurfaceOptions> surfaceOptions() const;

  SessionOptions options;
  std::optional<std::string> receiver, folder, reference, surfaces, surfaceEdge;
  bool json = false, decompose = false;
  TechniqueCatalogue catalogue = allTechniques();
};

CompareCommand::CompareCommand(OptionParser& command) {
  const std::string group = "Compare";
  command.add(
      "--receiver", receiver,
      {group, "Z",
       "Of a depth map: a receiver plane at this linear depth, 0 to 1, or a distance such as 6w, "
       "or a value of the file such as 0.97f"});
  command.add(
      "-o,--output", folder,
      {group, "DIR",
       "Write compare.json, compare.csv and, of a scene, each technique's error picture and "
       "error-against-cost as PNG, SVG, PDF and CSV; "
       "with --decompose the parts as decomposition-TECHNIQUE.exr"});
  command.addFlag(
      "--decompose", decompose,
      {group, "",
       "Of a scene: also take each technique's error apart, into bleeding, contact leak, "
       "over-darkening, reduction and precision; with --reference raytraced also into the "
       "map's own error"});
  command.add("--reference", reference,
              {group, "pcf|raytraced",
               "What is true: exact percentage-closer filtering of the map (the default), or, of "
               "a scene, of a map of unlimited resolution, by rays through every texel"});
  command.add("--surfaces", surfaces,
              {group, "vtp|ply",
               "Of a scene: also the error on its surfaces, whoever looks at them, with areas; "
               "-o writes bleeding-TECHNIQUE.vtp or .ply, a mesh with the error at every vertex "
               "and face; against what --reference says"});
  command.add("--surface-edge", surfaceEdge,
              {group, "TEXELS",
               "Of --surfaces: no edge is longer on the map, texels, 0.5 to 256 (default 4)"});
  command.addFlag("--json", json, {group, "", "Print one JSON object"});
  command.setFooter(
      "The error is visibility minus exact percentage-closer filtering over the same region; a\n"
      "scene counts every pixel that faces the light inside its map, a depth map every texel.\n"
      "With --reference raytraced that includes the error of the map itself, which pcf's row "
      "shows\n"
      "alone. Of frames with very wide regions it counts an even grid of pixels ('samples'), and "
      "-o\n"
      "writes no error pictures. --surfaces counts what faces the light inside its map: of a body "
      "the\n"
      "outside, of a sheet both sides. Of a session that compares every pane is a row, with its "
      "own\n"
      "settings, unless --technique names techniques.");
  options.addTo(command);
}

// The panes of a session that compares, unless techniques are named.
std::vector<Drawing> CompareCommand::drawings(const Workspace& workspace) const {
  if (!options.namesTechniques() && workspace.comparison.mode != ComparisonMode::Single)
    return drawingsOfPanes(workspace, catalogue);
  Session session = sessionOf(workspace);
  session.frame = readSettingsOf(session);
  return drawingsOf(
      session,
      makeTechniques(session, catalogue, options.techniques(catalogue, everyTechnique(catalogue))));
}

bool CompareCommand::rayTraced() const {
  return reference && rayTracedFrom(*reference, "--reference");
}

std::optional<SurfaceOptions> CompareCommand::surfaceOptions() const {
  if (surfaceEdge && !surfaces)
    throw Error(ErrorKind::BadCommandLine, "--surface-edge: only goes with --surfaces");
  if (!surfaces) return std::nullopt;
  SurfaceOptions asked{surfaceFormatFrom(*surfaces, "--surfaces"), {}};
  if (surfaceEdge) asked.mesh.edge = surfaceEdgeFrom(*surfaceEdge, "--surface-edge");
  return asked;
}

void CompareCommand::run() const {
  if (json && folder)
    throw Error(ErrorKind::BadCommandLine, "--json: excludes -o, give one of them");
  if (folder) checkWritable(std::filesystem::path(*folder) / "compare.json");
  const Workspace workspace = options.workspace(catalogue);
  if (workspace.shared.source.kind == SourceKind::DepthFile)
    compareMap(workspace);
  else
    compareScene(workspace);
}

void CompareCommand::compareMap(Workspace workspace) const {
  Session& session = workspace.shared;
  if (!receiver && !session.receiver)
    throw Error(ErrorKind::BadCommandLine, "--receiver: is missing, give --receiver Z");
  if (rayTraced())
    throw Error(
        ErrorKind::BadCommandLine,
        "--reference: a depth map has no surfaces that rays could meet; raytraced goes with "
        "a scene");
  if (decompose)
    throw Error(ErrorKind::BadCommandLine, "--decompose: goes with a scene, not with --depth");
  if (surfaceOptions())
    throw Error(ErrorKind::BadCommandLine,
                "--surfaces: a depth map has none; give --scene NAME or a mesh file");
  if (!options.namesFormat() && !options.namesSession()) chooseFormatFor(session);
  const std::vector<Drawing> chosen = drawings(workspace);
  const DepthFile file = loadedDepth(session.source);
  const DepthMap& map = file.map;
  if (receiver && receiver->ends_with('f') && file.scale.dependsOnTexel())
    throw Error(
        ErrorKind::BadCommandLine,
        "--receiver: a value of the file is another distance to the light at each texel; give "
        "a linear depth from 0 to 1 or a distance such as 6w");
  if (receiver) session.receiver = receiverFrom(*receiver, "--receiver", file, 0, 0);
  std::vector<MetricsRow> rows;
  // Drawings with the same settings are measured together, in one walk over the map.
  for (std::size_t first = 0; first < chosen.size();) {
    const FrameSettings frame = chosen[first].session.frame;
    std::vector<std::shared_ptr<const Technique>> adapted;
    std::size_t next = first;
    for (; next < chosen.size() && chosen[next].session.frame == frame; ++next) {
      throwIfCancelled();
      chosen[next].technique->adapt(map);
      adapted.push_back(chosen[next].technique);
    }
    const StorageFormat format = frame.map.format;
    const auto figures =
        figuresOnMap(map, adapted, frame.kernel, format, *session.receiver, throwIfCancelled);
    for (std::size_t i = 0; i < adapted.size(); ++i) {
      MetricsRow row{std::string(adapted[i]->info().id), figures[i].metrics, figures[i].reduction};
      row.pane = chosen[first + i].pane;
      row.differences = chosen[first + i].differences;
      rows.push_back(std::move(row));
    }
    first = next;
  }
  throwIfCancelled();
  if (!json && !folder) return print(compareText(rows));
  Json object = compareToJson(rows);
  addReceiver(object, shortNameOf(session.source), file, *session.receiver);
  if (json) return printJson(object);
  OutputFolder files(*folder);
  writeCompare(files, object);
  files.finish();
}

void CompareCommand::compareScene(const Workspace& workspace) const {
  if (receiver) throw Error(ErrorKind::BadCommandLine, "--receiver: only goes with --depth");
  const std::optional<SurfaceOptions> asked = surfaceOptions();
  const Session session = sessionOf(workspace);
  checkGpuFormat(session);
  const std::vector<Drawing> chosen = drawings(workspace);
  for (const Drawing& drawing : chosen) checkGpuFormat(drawing.session);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  std::optional<OutputFolder> files;
  if (folder) files.emplace(*folder);
  std::optional<SurfaceCompare> onSurfaces;
  std::optional<RayTracedReference> rays;   // the same whatever the technique
  const FrameSettings* settings = nullptr;  // of both
  std::vector<MetricsRow> rows;
  for (const Drawing& drawing : chosen) {
    throwIfCancelled();
    const Technique& technique = *drawing.technique;
    if (!settings || !(drawing.session.frame == *settings)) {
      rays.reset();
      if (asked) onSurfaces.emplace(drawing.session.frame, *asked, rayTraced());
      settings = &drawing.session.frame;
    }
    frame->show(scene, drawing.session);
    frame->render(technique, rayTraced() ? ViewMode::Shaded : ViewMode::Error);
    if (rayTraced() && !rays) rays = rayTracedReference(*frame);
    if (files && !rays)
      display->writePictures({{drawing.name, frame->colour()}},
                             files->file("error-" + drawing.name + ".png"),
                             sessionAttributes(Workspace{drawing.session}, UMBRA_VERSION));
    std::optional<ErrorSums> parts;
    std::optional<double> mapError;
    if (decompose) {
      const DecomposedFrame taken = decomposeFrame(*frame, rays ? &*rays : nullptr);
      parts = sumsOf(taken.parts);
      mapError = taken.meanOfMap;
      if (files)
        decompositionFile(drawing.session, technique, taken)
            .write(files->file("decomposition-" + drawing.name + ".exr"));
    }
    std::optional<SurfaceErrors> onMesh;
    if (onSurfaces) onMesh = onSurfaces->errors(*frame);
    if (onMesh && files)
      onSurfaces->write(onMesh->mesh, files->file(onSurfaces->fileName(drawing.name)), *display);
    MetricsRow& row = rows.emplace_back(compareFrame(*frame, technique, rays ? &*rays : nullptr));
    row.decomposition = parts;
    row.mapError = mapError;
    if (onMesh) row.surfaces = onMesh->summary;
    row.pane = drawing.pane;
    row.differences = drawing.differences;
    row.cost = frame->cost(technique);
  }
  throwIfCancelled();
  const std::string_view truth = rays ? "raytraced" : "pcf";
  if (json) return printJson(compareToJson(rows, truth));
  if (!files) return print(compareText(rows));
  writeCompare(*files, compareToJson(rows, truth));
  if (rows.size() > 1) {  // one alone is beside nothing
    std::vector<CostPoint> points;
    for (std::size_t i = 0; i < rows.size(); ++i)
      points.push_back({nameOf(rows[i]), std::string(chosen[i].technique->info().colour),
                        rows[i].cost->bakeMs + rows[i].cost->shadeMs, rows[i].metrics.rmse});
    const Plot plots[] = {errorAgainstCostPlot(points)};
    writePlots(*files, *display, plots);
  }
  files->finish();
}

}  // namespace

Command addCompare(OptionParser& program) {
  OptionParser command =
      program.addCommand("compare", "Measure techniques against the reference", commandsGroup);
  const auto compare = std::make_shared<CompareCommand>(command);
  return {command, [compare] { compare->run(); }};
}

}  // namespace umbra

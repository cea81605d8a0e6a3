#include "app/options/SessionOptions.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/options/OptionValues.h"
#include "app/options/SceneSources.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// However the path of a file is written.
bool sameSource(SceneSource a, SceneSource b) {
  for (SceneSource* source : {&a, &b}) {
    if (source->kind == SourceKind::Catalogue) continue;
    std::error_code unreadable;  // leaves the name as it is
    const auto path = std::filesystem::weakly_canonical(source->name, unreadable);
    if (!unreadable) source->name = path.string();
  }
  return a == b;
}

}  // namespace

void SessionOptions::addTo(CLI::App& command) {
  addInput(command);
  addTechnique(command);
  addMap(command);
  addRead(command);
  addView(command);
}

void SessionOptions::addInput(CLI::App& command) {
  const std::string group = "Input";
  command
      .add_option("--scene", scene_, "Scene of the catalogue, or mesh file (.obj .ply .off .stl)")
      ->type_name("NAME|FILE")
      ->group(group);
  command.add_option("--scene-set", sceneSettings_, "Adjust the scene, see `scenes`; repeatable")
      ->type_name("PARAMETER=VALUE")
      ->take_all()
      ->expected(1)
      ->group(group);
  command
      .add_option("--depth", depth_,
                  "Depth map instead of a scene: a float or half channel, by default Z")
      ->type_name("FILE.exr[:CHANNEL]")
      ->group(group);
  command.add_option("--depth-range", depthRange_, "Depths that become 0 and 1 (default 0,1)")
      ->type_name("NEAR,FAR")
      ->group(group);
  command.add_option("--session", session_, "Start from a saved session; options override it")
      ->type_name("FILE.json")
      ->group(group);
}

void SessionOptions::addTechnique(CLI::App& command) {
  const std::string group = "Technique and prefilter";
  command.add_option("--technique", techniques_, "One or more techniques, see `techniques`")
      ->type_name("A[,B...]|all")
      ->group(group);
  command
      .add_option("--set", settings_, "Set a technique's parameter, see `techniques`; repeatable")
      ->type_name("TECHNIQUE.PARAMETER=VALUE")
      ->take_all()
      ->expected(1)
      ->group(group);
  command.add_option("--kernel", kernel_, "Prefilter: none, box (default) or gaussian")
      ->type_name("NAME")
      ->group(group);
  command
      .add_option("--radius", radius_, "Radius r of the (2r+1)x(2r+1) kernel, texels (default 3)")
      ->type_name("R")
      ->group(group);
  command.add_option("--sigma", sigma_, "Gaussian's standard deviation, texels (default r/2)")
      ->type_name("S")
      ->group(group);
}

void SessionOptions::addMap(CLI::App& command) {
  const std::string group = "Shadow map";
  const auto add = [&](const std::string& name, Text& value, const std::string& type,
                       const std::string& text) {
    command.add_option(name, value, text)->type_name(type)->group(group);
  };
  add("--map-size", mapSize_, "N", "Texels a side, 16 to 8192 (default 1024)");
  add("--format", format_, "NAME",
      "Channel storage: unorm8, unorm16, half or float (default); a depth map also takes double");
  add("--msaa", msaa_, "N", "Depths a texel: 1 (default), 2, 4 or 8, as far as the driver can");
  add("--cascades", cascades_, "N", "Shadow maps along the view, 1 (default) to 4");
  add("--split-lambda", splitLambda_, "L",
      "Where cascades split: 0 evenly to 1 logarithmically (default 0.5)");
  add("--cascade-seam", cascadeSeam_, "S",
      "Part of a cascade that goes over into the next, 0 to 0.5 (default 0.1)");
  add("--bias-constant", biasConstant_, "D", "Depth taken off every receiver (default 0.0005)");
  add("--bias-slope", biasSlope_, "T", "Texels of the receiver's slope taken off (default 1)");
  add("--bias-receiver-plane", biasReceiverPlane_, "on|off",
      "Slope also over half the filter region (default on)");
  add("--cull-front-faces", cullFrontFaces_, "on|off",
      "Casters' faces towards the light leave no depth (default off)");
}

void SessionOptions::addRead(CLI::App& command) {
  const std::string group = "Read of the shaded frame";
  const auto add = [&](const std::string& name, Text& value, const std::string& type,
                       const std::string& text) {
    command.add_option(name, value, text)->type_name(type)->group(group);
  };
  add("--filter", filter_, "NAME",
      "point, bilinear (default), trilinear, anisotropic or sat: summed-area table");
  add("--anisotropy", anisotropy_, "N", "Reads of --filter anisotropic, at most: 1 to 16 (8)");
  add("--sat-size", satSize_, "NAME",
      "Box of --filter sat, at least the kernel's: footprint of the pixel (default), distance: "
      "wider near the camera, or fixed");
  add("--sat-distance", satDistance_, "D",
      "With --sat-size distance: where the box is the kernel's, world units (default 0: as far as "
      "the lit scene is wide)");
  add("--sat-precision", satPrecision_, "NAME",
      "Sums of --filter sat: centred (default) or plain floats, or integer");
}

void SessionOptions::addView(CLI::App& command) {
  const std::string group = "View";
  command
      .add_option(
          "--light", light_,
          "Casting light, world; left out parts stay the scene's: " + std::string(lightSyntax))
      ->type_name("LIGHT")
      ->group(group);
  command
      .add_option("--camera", camera_,
                  "Camera, world, angle in degrees: " + std::string(cameraSyntax))
      ->type_name("CAMERA")
      ->group(group);
  command.add_option("--size", size_, "Picture, pixels (default 1280x720)")
      ->type_name("WxH")
      ->group(group);
  command
      .add_option("--view", view_, "shaded (default), visibility, error, depth, layers or cascades")
      ->type_name("NAME")
      ->group(group);
}

bool SessionOptions::given(const CLI::App& command) const {
  const std::vector<const CLI::Option*> options = command.get_options();
  return std::any_of(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->count() > 0 && !option->get_positional();
  });
}

Session SessionOptions::session(const TechniqueCatalogue& catalogue) const {
  Session start;
  if (session_) refuseEmpty(*session_, "--session", "FILE.json");
  if (session_) start = readSession(*session_);
  return over(std::move(start), catalogue);
}

Session SessionOptions::over(Session base, const TechniqueCatalogue& catalogue) const {
  editSource(base);
  editTechniques(base, catalogue);
  editMap(base);
  editRead(base.frame.read);
  editBias(base.frame.bias);
  editView(base);
  return base;
}

void SessionOptions::editSource(Session& session) const {
  if (scene_ && depth_)
    throw Error(ErrorKind::BadCommandLine, "--depth: excludes --scene, give one of them");
  if (scene_) refuseEmpty(*scene_, "--scene", "NAME or FILE");
  if (depth_) refuseEmpty(*depth_, "--depth", "FILE.exr[:CHANNEL]");
  const SceneSource former = session.source;
  if (scene_) session.source = sceneSourceFrom(*scene_, "--scene");
  if (depth_) {
    session.source = {};
    session.source.kind = SourceKind::DepthFile;
    std::tie(session.source.name, session.source.channel) = splitDepthArgument(*depth_);
  }
  if (depthRange_) {
    if (session.source.kind != SourceKind::DepthFile)
      throw Error(ErrorKind::BadCommandLine, "--depth-range: only goes with --depth");
    std::tie(session.source.depthNear, session.source.depthFar) =
        depthRangeFrom(*depthRange_, "--depth-range");
  }
  for (const std::string& setting : sceneSettings_) adjustScene(session.source, setting);
  if ((scene_ || depth_) && !sameSource(session.source, former)) {  // places of another one
    session.probes.clear();
    session.keptProbe.clear();
  }
}

std::vector<std::string> idsOf(const TechniqueCatalogue& catalogue) {
  std::vector<std::string> ids;
  for (const Technique* technique : catalogue.all()) ids.emplace_back(technique->info().id);
  return ids;
}

TechniqueChoice everyTechnique(const TechniqueCatalogue& catalogue) {
  return {idsOf(catalogue), true};
}

TechniqueChoice SessionOptions::techniques(const TechniqueCatalogue& catalogue,
                                           const TechniqueChoice& fallback) const {
  if (!techniques_) return fallback;
  const std::vector<std::string> named = split(*techniques_, ',');
  const bool all = std::find(named.begin(), named.end(), "all") != named.end();
  std::vector<std::string> ids;
  for (const std::string& id : named) {
    if (id != "all" && !catalogue.has(id)) {
      const std::vector<std::string> known = idsOf(catalogue);
      const std::string nearest = nearestWord(id, known);
      throw Error(ErrorKind::BadCommandLine,
                  "--technique: there is no '" + id + "'; " +
                      (nearest.empty() ? "there are " + joined(known) + " and all"
                                       : "did you mean '" + nearest + "'?"));
    }
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  if (ids.empty())
    throw Error(ErrorKind::BadCommandLine, "--technique: is empty, it takes A[,B...] or all");
  return all ? everyTechnique(catalogue) : TechniqueChoice{ids, false};
}

void SessionOptions::editTechniques(Session& session, const TechniqueCatalogue& catalogue) const {
  // One of all is no choice: the session's own stays the one to look at.
  const TechniqueChoice choice = techniques(catalogue, {{session.technique}});
  if (!choice.all) chooseTechnique(session, choice.ids.front());
  for (const std::string& setting : settings_) {
    const auto [name, text] = assignmentFrom(setting, "--set");
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos)
      throw Error(ErrorKind::BadCommandLine,
                  "--set: '" + setting + "' is not right, it takes TECHNIQUE.PARAMETER=VALUE");
    const std::string id = name.substr(0, dot), parameter = name.substr(dot + 1);
    try {
      catalogue.make(id, "--set " + name);
      editParameters(session, catalogue, id, [&](std::span<const Parameter> parameters) {
        parameterNamed(parameters, parameter, "--set " + name).setFromText(text, "--set " + name);
      });
    } catch (const Error& error) {
      // The value came from the command line, whatever reads values from files calls it.
      const bool prefixed = std::string_view(error.what()).starts_with("--set");
      throw Error(ErrorKind::BadCommandLine,
                  (prefixed ? "" : "--set: ") + std::string(error.what()));
    }
  }
}

void SessionOptions::editMap(Session& session) const {
  FrameSettings& frame = session.frame;
  if (kernel_) frame.kernel.shape = kernelShapeFrom(*kernel_, "--kernel");
  if (radius_) frame.kernel.radius = integerFrom(*radius_, "--radius", 0, Kernel::largestRadius);
  if (sigma_) frame.kernel.sigma = sigmaFrom(*sigma_, "--sigma");
  if (mapSize_)
    frame.map.size =
        integerFrom(*mapSize_, "--map-size", MapSettings::smallest, MapSettings::largest);
  if (format_) frame.map.format = storageFormatFrom(*format_, "--format");
  if (msaa_) frame.map.samples = samplesFrom(*msaa_, "--msaa");
  CascadeSettings& cascades = frame.map.cascades;
  if (cascades_)
    cascades.count = integerFrom(*cascades_, "--cascades", 1, CascadeSettings::largestCount);
  if (splitLambda_) cascades.splitLambda = numberFrom(*splitLambda_, "--split-lambda", {0.0, 1.0});
  if (cascadeSeam_)
    cascades.seam =
        numberFrom(*cascadeSeam_, "--cascade-seam", {0.0, CascadeSettings::largestSeam});
}

void SessionOptions::editRead(ReadSettings& read) const {
  if (filter_) read.filter = readFilterFrom(*filter_, "--filter");
  if (anisotropy_)
    read.anisotropy = integerFrom(*anisotropy_, "--anisotropy", 1, ReadSettings::largestAnisotropy);
  if (satSize_) read.satSize = satSizeFrom(*satSize_, "--sat-size");
  if (satPrecision_) read.satPrecision = satPrecisionFrom(*satPrecision_, "--sat-precision");
  if (satDistance_)
    read.satDistance =
        numberFrom(*satDistance_, "--sat-distance", {0.0, ReadSettings::largestSatDistance});
}

void SessionOptions::editBias(Bias& bias) const {
  if (biasConstant_)
    bias.constant = numberFrom(*biasConstant_, "--bias-constant", {0.0, Bias::largestConstant});
  if (biasSlope_) bias.slope = numberFrom(*biasSlope_, "--bias-slope", {0.0, Bias::largestSlope});
  if (biasReceiverPlane_)
    bias.receiverPlane = switchFrom(*biasReceiverPlane_, "--bias-receiver-plane");
  if (cullFrontFaces_) bias.cullFrontFaces = switchFrom(*cullFrontFaces_, "--cull-front-faces");
}

void SessionOptions::editView(Session& session) const {
  if (size_) std::tie(session.width, session.height) = sizeFrom(*size_, "--size");
  if (view_) session.frame.view = viewModeFrom(*view_, "--view");
  if (!light_ && !camera_) return;
  if (session.source.kind == SourceKind::DepthFile)
    throw Error(ErrorKind::BadCommandLine,
                std::string(light_ ? "--light" : "--camera") + ": only goes with a scene");
  const Scene scene = loadScene(session.source);
  if (light_) session.light = lightFrom(*light_, "--light", session.light.value_or(scene.light));
  if (camera_)
    session.camera = cameraFrom(*camera_, "--camera", session.camera.value_or(scene.camera));
}

}  // namespace umbra

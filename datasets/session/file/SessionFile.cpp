#include "datasets/session/file/SessionFile.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "datasets/json/JsonText.h"
#include "datasets/maps/Raster.h"
#include "datasets/session/file/JsonObject.h"
#include "datasets/session/file/SessionFileCompare.h"
#include "datasets/session/file/SessionFileParameters.h"
#include "datasets/session/file/SessionFileProbes.h"
#include "datasets/session/file/SessionFileSettings.h"
#include "datasets/session/file/SessionInExr.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

Json sourceJson(const SceneSource& source) {
  switch (source.kind) {
    case SourceKind::MeshFile: {
      Json json{{"mesh", source.name}};
      if (source.up != UpAxis::Y) json["up"] = nameOf(source.up);
      return json;
    }
    case SourceKind::DepthFile: {
      Json json{{"depth", source.name}};
      const DepthImport& depth = source.depth;
      if (!depth.channel.empty()) json["channel"] = depth.channel;
      json["range"] = {depth.atZero, depth.atOne};
      if (depth.projection != DepthProjection()) json["projection"] = toText(depth.projection);
      if (depth.miss != DepthMiss()) json["miss"] = toText(depth.miss);
      return json;
    }
    case SourceKind::Catalogue:
      break;
  }
  Json json{{"scene", source.name}};
  if (!source.parameters.empty()) json["parameters"] = source.parameters;
  return json;
}

// The file itself, or what an OpenEXR file of this program holds.
std::string sessionTextOf(const std::filesystem::path& file) {
  if (rasterReaderOf(file) != readExr) return textOf(file);
  const std::optional<std::string> text = sessionInExr(file);
  if (!text)
    throw Error(ErrorKind::BadInput,
                file.string() + ": holds no session; files that `render` and `encode` write do");
  return *text;
}

double numberAt(const Json& value, const std::string& where) {
  if (!value.is_number())
    throw Error(ErrorKind::BadInput, where + ": " + quoted(value) + " should be a number");
  return value.get<double>();
}

void readPair(const Json& value, const std::string& where, double& first, double& second) {
  if (!value.is_array() || value.size() != 2)
    throw Error(ErrorKind::BadInput, where + ": " + quoted(value) + " should be two numbers");
  first = numberAt(value[0], where);
  second = numberAt(value[1], where);
}

void readSource(JsonObject& object, SceneSource& source) {
  std::string scene, mesh, depth;
  object.read("scene", scene);
  object.read("mesh", mesh);
  object.read("depth", depth);
  if (int(!scene.empty()) + int(!mesh.empty()) + int(!depth.empty()) != 1)
    throw Error(ErrorKind::BadInput,
                object.where() + ": needs exactly one of 'scene', 'mesh' and 'depth'");
  source = SceneSource{};
  if (!scene.empty()) {
    source.name = scene;
    object.readObject("parameters", [&](JsonObject& parameters) {
      parameters.readRest([&](const std::string& key, const Json& value, const std::string& where) {
        source.parameters[key] = numberAt(value, where);
      });
    });
  } else if (!mesh.empty()) {
    source.kind = SourceKind::MeshFile;
    source.name = mesh;
    object.readName("up", [&](const std::string& name, const std::string& where) {
      source.up = upAxisFrom(name, where);
    });
  } else {
    source.kind = SourceKind::DepthFile;
    source.name = depth;
    object.read("channel", source.depth.channel);
    object.readName("projection", [&](const std::string& name, const std::string& where) {
      source.depth.projection = projectionFrom(name, where);
    });
    object.readName("miss", [&](const std::string& name, const std::string& where) {
      source.depth.miss = depthMissFrom(name, where);
    });
    object.readRest([&](const std::string& key, const Json& value, const std::string& where) {
      if (key != "range") throw Error(ErrorKind::BadInput, where + ": there is no such key");
      readPair(value, where, source.depth.atZero, source.depth.atOne);
    });
  }
}

Pixel pixelFrom(const Json& value, const std::string& where) {
  constexpr int largest = Session::largestSide - 1;
  double x = 0.0, y = 0.0;
  readPair(value, where, x, y);
  const auto fits = [&](double n) { return n >= 0 && n <= largest && n == std::floor(n); };
  if (!fits(x) || !fits(y))
    throw Error(ErrorKind::BadInput, where + ": " + quoted(value) +
                                         " should be two whole numbers from 0 to " +
                                         std::to_string(largest));
  return {int(x), int(y)};
}

}  // namespace

Json toJson(const Workspace& workspace) {
  Session session = workspace.shared;  // a copy, since settings are bound to what they read
  Json json{{"format", sessionFormat}, {"source", sourceJson(session.source)}};
  if (session.light) json["light"] = lightJson(*session.light);
  if (session.camera) json["camera"] = cameraJson(*session.camera);
  writeSettings(json["frame"], settingsOf(session.frame));
  json["technique"] = session.technique;
  json["parameters"] = Json::object();
  for (const auto& [id, values] : session.parameters)
    if (!values.empty()) json["parameters"][id] = toJson(values);
  if (!workspace.comparison.panes.empty())
    json["compare"] = comparisonJson(comparisonOf(workspace));
  else if (!(workspace.comparison == Comparison{}))
    json["compare"] = comparisonJson(workspace.comparison);
  writeSettings(json, pictureSettingsOf(session));
  if (session.probe) json["probe"] = {session.probe->x, session.probe->y};
  if (session.receiver) json["receiver"] = *session.receiver;
  if (!session.probes.empty()) json["probes"] = probesJson(session.probes);
  if (!session.keptProbe.empty()) json["keptProbe"] = session.keptProbe;
  return json;
}

Workspace workspaceFrom(const Json& json, std::string_view where) {
  Workspace workspace;
  Session& session = workspace.shared;
  JsonObject object(json, std::string(where));
  std::string format;
  object.read("format", format);
  if (format != sessionFormat)
    throw Error(
        ErrorKind::BadInput,
        std::string(where) + ": is no session, its \"format\" should be \"" + sessionFormat + "\"");
  object.readObject("source", [&](JsonObject& source) { readSource(source, session.source); });
  object.readObject("light", [&](JsonObject& light) { session.light = lightFrom(light); });
  object.readObject("camera", [&](JsonObject& camera) { session.camera = cameraFrom(camera); });
  object.readObject("frame",
                    [&](JsonObject& frame) { readSettings(frame, settingsOf(session.frame)); });
  object.readName("technique", [&](const std::string& id, const std::string& place) {
    session.technique = allTechniques().make(id, place)->info().id;
  });
  object.readObject("parameters", [&](JsonObject& parameters) {
    readParameters(parameters, session.parameters);
  });
  object.readObject("compare", [&](JsonObject& comparison) {
    workspace.comparison = readComparison(comparison, session);
  });
  double receiver = -1.0;
  object.read("receiver", receiver, 0.0, 1.0);
  if (receiver >= 0.0) session.receiver = receiver;
  readProbes(object, session);
  readSettings(object, pictureSettingsOf(session));
  object.readValue("probe", [&](const Json& value, const std::string& place) {
    session.probe = pixelFrom(value, place);
  });
  if (!session.keptProbe.empty() && !session.probe)
    throw Error(ErrorKind::BadInput,
                std::string(where) + ": keptProbe: needs a 'probe', the pixel or texel it is at");
  object.finish();
  return workspace;
}

std::string toText(const Workspace& workspace) {
  return toJson(workspace).dump(2) + "\n";
}

Workspace workspaceFromText(std::string_view text, std::string_view where) {
  return workspaceFrom(jsonFromText(text, where), where);
}

Workspace readWorkspace(const std::filesystem::path& file) {
  Workspace workspace = workspaceFromText(sessionTextOf(file), file.string());
  SceneSource& source = workspace.shared.source;
  if (source.kind != SourceKind::Catalogue)
    source.name =
        (std::filesystem::absolute(file).parent_path() / source.name).lexically_normal().string();
  return workspace;
}

void writeWorkspace(const Workspace& workspace, const std::filesystem::path& file) {
  Workspace relative = workspace;
  SceneSource& source = relative.shared.source;
  if (source.kind != SourceKind::Catalogue) {
    const auto folder = std::filesystem::absolute(file).parent_path();
    source.name = std::filesystem::absolute(source.name)
                      .lexically_normal()
                      .lexically_proximate(folder)
                      .string();
  }
  writeTextAtomically(file, toText(relative));
}

}  // namespace umbra

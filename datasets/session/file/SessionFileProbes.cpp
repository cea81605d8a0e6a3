#include "datasets/session/file/SessionFileProbes.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "datasets/json/JsonText.h"
#include "datasets/session/file/SessionFileSettings.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

Pixel texelFrom(const Json& value, const std::string& where) {
  const auto fits = [](const Json& number) {
    return number.is_number_integer() && number.get<double>() >= 0 &&
           number.get<double>() < Session::largestSide;
  };
  if (!value.is_array() || value.size() != 2 || !fits(value[0]) || !fits(value[1]))
    throw Error(ErrorKind::BadInput, where + ": " + quoted(value) +
                                         " should be two whole numbers from 0 to " +
                                         std::to_string(Session::largestSide - 1));
  return {value[0].get<int>(), value[1].get<int>()};
}

Eigen::Vector3d pointFrom(JsonObject& object) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  readPoint(object, "point", point);
  if (point.cwiseAbs().maxCoeff() > largestCoordinate)
    throw Error(ErrorKind::BadInput, object.where() + ".point: has a coordinate beyond " +
                                         shortNumber(largestCoordinate) +
                                         ", which is out of reach");
  return point;
}

NamedProbe probeFrom(const Json& json, const std::string& where, const Session& session) {
  NamedProbe probe;
  JsonObject object(json, where);
  object.read("name", probe.name);
  if (const std::string reason = whyNotProbeName(session.probes, probe.name); !reason.empty())
    throw Error(ErrorKind::BadInput, where + ".name: " + reason);
  const bool onFile = session.source.kind == SourceKind::DepthFile;
  if (json.contains("point") == onFile || json.contains("texel") != onFile)
    throw Error(ErrorKind::BadInput,
                where + (onFile ? ": on a depth file needs a 'texel' and no 'point'"
                                : ": on a scene needs a 'point' and no 'texel'"));
  if (!onFile) probe.point = pointFrom(object);
  double receiver = -1.0;
  object.read("receiver", receiver, 0.0, 1.0);
  if (receiver >= 0.0) probe.receiver = receiver;
  object.readRest([&](const std::string& key, const Json& value, const std::string& place) {
    if (key != "texel") throw Error(ErrorKind::BadInput, place + ": there is no such key");
    probe.texel = texelFrom(value, place);
  });
  return probe;
}

}  // namespace

Json probesJson(const std::vector<NamedProbe>& probes) {
  Json list = Json::array();
  for (const NamedProbe& probe : probes) {
    Json& json = list.emplace_back(Json{{"name", probe.name}});
    if (probe.point) json["point"] = pointJson(*probe.point);
    if (probe.texel) json["texel"] = {probe.texel->x, probe.texel->y};
    if (probe.receiver) json["receiver"] = *probe.receiver;
  }
  return list;
}

void readProbes(JsonObject& object, Session& session) {
  object.readList("probes", [&](const Json& element, const std::string& where) {
    if (session.probes.size() == NamedProbe::most)
      throw Error(ErrorKind::BadInput, where + ": is one too many, at most " +
                                           std::to_string(NamedProbe::most) + " are saved");
    session.probes.push_back(probeFrom(element, where, session));
  });
  object.readName("keptProbe", [&](const std::string& name, const std::string& where) {
    if (!probeNamed(session.probes, name))
      throw Error(ErrorKind::BadInput, where + ": there is no probe '" + name + "' among 'probes'");
    session.keptProbe = name;
  });
}

}  // namespace umbra

#include "app/reports/Reports.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/probe/Explain.h"
#include "app/output/Cancellation.h"
#include "app/reports/SurfaceReport.h"

namespace umbra {
namespace {

std::string_view nameOf(Reduction reduction) {
  switch (reduction) {
    case Reduction::Mean:
      return "mean";
    case Reduction::Min:
      return "min";
    case Reduction::Max:
      return "max";
  }
  return "";
}

Json finiteOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json regionToJson(const Region& region) {
  return {{"texel", {region.x, region.y}},
          {"kernel", nameOf(region.kernel.shape)},
          {"radius", region.kernel.effectiveRadius()},
          {"texels", region.texels.size()}};
}

Json statisticsToJson(const RegionStatistics& statistics) {
  return {{"mean", statistics.mean},         {"secondMoment", statistics.secondMoment},
          {"variance", statistics.variance}, {"min", statistics.min},
          {"max", statistics.max},           {"beta", finiteOrNull(statistics.beta)}};
}

Json techniquesToJson(const Probe& probe) {
  Json rows = Json::array();
  for (const TechniqueResult& result : probe.techniques) {
    Json row = {{"name", result.technique->info().id},
                {"parameters", parametersOf(*result.technique)},
                {"visibility", result.visibility},
                {"error", result.error}};
    if (result.gpu) row["gpu"] = *result.gpu;
    if (const auto reduction = bleedReductionOf(probe, result))
      row["smallestReduction"] = {{"amount", reduction->amount},
                                  {"darkening", reduction->darkening},
                                  {"removesAll", reduction->removesAll}};
    rows.push_back(row);
  }
  return rows;
}

Json traceToJson(const Trace& trace) {
  Json steps = Json::array(), shares = Json::array();
  for (const TraceStep& step : trace.steps)
    steps.push_back({{"symbol", step.symbol},
                     {"meaning", step.meaning},
                     {"formula", step.formula},
                     {"value", finiteOrNull(step.value)}});
  for (const ErrorShare& share : trace.shares)
    shares.push_back(
        {{"cause", nameOf(share.cause)}, {"step", share.step}, {"amount", share.amount}});
  return {{"steps", steps},
          {"cause", nameOf(trace.cause)},
          {"step", trace.culprit ? Json(*trace.culprit) : Json(nullptr)},
          {"sentence", trace.sentence},
          {"shares", shares}};
}

Json curvesToJson(const Probe& probe, int samples) {
  const Curves curves = curvesOf(probe, samples, throwIfCancelled);
  Json object = {{"depth", curves.depth}, {"reference", curves.reference}};
  for (std::size_t i = 0; i < probe.techniques.size(); ++i)
    object[std::string(probe.techniques[i].technique->info().id)] = curves.techniques[i];
  return object;
}

Json decompositionToJson(const ErrorSums& sums, const std::optional<double>& mapError) {
  Json object = {{"error", sums.error + mapError.value_or(0.0)}};
  if (mapError) object["map"] = *mapError;
  for (int i = 0; i < errorPartCount; ++i)
    object[std::string(nameOf(ErrorPart(i)))] = sums.means[i];
  return object;
}

}  // namespace

Json parametersOf(const Technique& technique) {
  Json object = Json::object();
  for (const ParameterView& parameter : technique.parameters())
    object[std::string(parameter.name)] = toJson(parameter.get());
  return object;
}

Json sourceToJson(const std::string& name, const DepthMap& map) {
  return {{"name", name}, {"width", map.width()}, {"height", map.height()}};
}

Json sourceToJson(const std::string& name, const DepthFile& file) {
  Json source = sourceToJson(name, file.map);
  source["origin"] = {file.originX, file.originY};
  return source;
}

void countAsFile(Json& object, const DepthFile& file) {
  const int x = object["region"]["texel"][0], y = object["region"]["texel"][1];
  const double receiver = object["receiver"];
  object["source"]["origin"] = {file.originX, file.originY};
  object["region"]["texel"] = {x + file.originX, y + file.originY};
  object["receiverWorld"] = finiteOrNull(file.scale.worldOf(receiver));
  object["receiverFile"] = finiteOrNull(file.scale.fileOf(receiver, x, y));
}

void addReceiver(Json& object, const std::string& sourceName, const DepthFile& file,
                 double receiver) {
  object["source"] = sourceToJson(sourceName, file);
  object["receiver"] = receiver;
  object["receiverWorld"] = finiteOrNull(file.scale.worldOf(receiver));
  if (!file.scale.dependsOnTexel())
    object["receiverFile"] = finiteOrNull(file.scale.fileOf(receiver, 0, 0));
}

Json probeToJson(const Probe& probe, const DepthMap& map, const ProbeJsonDetail& detail) {
  const Histogram histogram = histogramOf(probe.region, detail.bins);
  Json object = {{"format", "umbrascope-probe/1"},
                 {"source", sourceToJson(detail.sourceName, map)},
                 {"region", regionToJson(probe.region)},
                 {"receiver", probe.receiver},
                 {"statistics", statisticsToJson(probe.statistics)},
                 {"reference", probe.reference},
                 {"techniques", techniquesToJson(probe)},
                 {"histogram", {{"edges", histogram.edges}, {"weights", histogram.weights}}}};
  if (detail.samples > 0) object["curves"] = curvesToJson(probe, detail.samples);
  return object;
}

void addTraces(Json& object, const Probe& probe) {
  for (std::size_t i = 0; i < probe.techniques.size(); ++i)
    object["techniques"][i]["trace"] = traceToJson(explain(probe, probe.techniques[i]));
}

void addRayTraced(Json& object, double visibility, bool replaces) {
  object["raytraced"] = visibility;
  object["errorAgainst"] = replaces ? "raytraced" : "pcf";
  if (!replaces) return;
  for (Json& row : object["techniques"])
    row["error"] = row["visibility"].get<double>() - visibility;
}

std::string rowName(std::string_view technique, std::size_t pane, const Json& differences) {
  std::string name(technique);
  if (pane == 0) return name;
  name += ", pane " + std::to_string(pane);
  std::string separator = ": ";
  for (const auto& [setting, value] : differences.items()) {
    name += separator + setting + " ";
    name += value.is_string() ? value.get<std::string>() : value.dump();
    separator = ", ";
  }
  return name;
}

Json compareToJson(const std::vector<MetricsRow>& rows, std::string_view reference) {
  Json techniques = Json::array();
  for (const auto& [id, metrics, reduction, decomposition, surfaces, mapError, pane, differences,
                    cost] : rows) {
    Json row = {{"name", id},
                {"rmse", metrics.rmse},
                {"mae", metrics.mae},
                {"bleeding", metrics.bleeding},
                {"darkening", metrics.darkening},
                {"max", metrics.max},
                {"min", metrics.min},
                {"umbraBleeding", metrics.umbraBleeding}};
    if (reduction)
      row["smallestReduction"] = {{"amount", reduction->amount},
                                  {"darkening", reduction->meanDarkening},
                                  {"maxDarkening", reduction->darkening},
                                  {"removesAll", reduction->removesAll}};
    if (decomposition) row["decomposition"] = decompositionToJson(*decomposition, mapError);
    if (surfaces) row["surfaces"] = surfacesToJson(*surfaces);
    if (cost)
      row["cost"] = {{"bakeMs", cost->bakeMs},
                     {"shadeMs", cost->shadeMs},
                     {"bytesStored", cost->bytesStored},
                     {"bytesUsed", cost->bytesUsed}};
    if (pane > 0) {
      row["pane"] = pane;
      row["settings"] = differences;
    }
    techniques.push_back(row);
  }
  return {{"format", "umbrascope-compare/1"},
          {"samples", rows.empty() ? 0 : rows.front().metrics.samples},
          {"reference", reference},
          {"techniques", techniques}};
}

Json techniqueToJson(const Technique& technique) {
  const TechniqueInfo& info = technique.info();
  Json channels = Json::array(), parameters = Json::array();
  for (const Channel& channel : technique.channels())
    channels.push_back({{"name", channel.name}, {"reduction", nameOf(channel.reduction)}});
  for (const ParameterView& parameter : technique.parameters()) {
    Json row = {{"name", parameter.name}, {"symbol", parameter.symbol}, {"unit", parameter.unit}};
    if (parameter.choices.empty())
      row["range"] = {parameter.low, parameter.high};
    else
      row["range"] = std::vector<std::string>(parameter.choices.begin(), parameter.choices.end());
    row["default"] = toJson(parameter.defaultValue);
    row["doc"] = parameter.doc;
    parameters.push_back(row);
  }
  return {{"name", info.id},
          {"title", info.title},
          {"citation", info.citation},
          {"summary", info.summary},
          {"formula", info.formula},
          {"colour", info.colour},
          {"upperBound", info.upperBound},
          {"prefilterable", info.prefilterable},
          {"channels", channels},
          {"parameters", parameters}};
}

Json sceneToJson(const SceneInfo& scene) {
  Json parameters = Json::array();
  for (const SceneParameter& parameter : scene.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"range", {parameter.low, parameter.high}},
                          {"default", parameter.value},
                          {"doc", parameter.doc}});
  return {
      {"name", scene.name},      {"title", scene.title},     {"description", scene.description},
      {"figure", scene.figure},  {"parameters", parameters}, {"available", scene.missing.empty()},
      {"missing", scene.missing}};
}

}  // namespace umbra

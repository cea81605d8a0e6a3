#include "app/bench/BenchReport.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/output/Table.h"
#include "filters/core/support/AtomicFile.h"

namespace umbra {
namespace {

constexpr std::array baselineNames{Baseline::NoShadow, Baseline::VtkShadowMapPass};

Spread spreadOf(const BenchReport& report, std::string_view name, std::string_view part) {
  return report.frames.samples.spread(std::string(name) + " " + std::string(part));
}

Json quartilesToJson(const Spread& spread) {
  return {spread.q1, spread.median, spread.q3};
}

Json motionToJson(const BenchReport& report, std::string_view name, Motion motion) {
  return {{"ms", quartilesToJson(spreadOf(report, name, nameOf(motion)))}};
}

Json settingsToJson(const Drawing& drawing) {
  Json settings = Json::object();
  for (const auto& [name, value] : valuesOf(drawing)) settings[name] = value;
  return settings;
}

Json caseToJson(const BenchReport& report, std::size_t i) {
  const Drawing& drawing = report.cases[i];
  Json passes = Json::object();
  for (const std::string& pass : report.frames.passes[i])
    passes[pass] = {{"ms", quartilesToJson(spreadOf(report, drawing.name, pass))}};
  return {{"name", drawing.name},
          {"technique", drawing.technique->info().id},
          {"settings", settingsToJson(drawing)},
          {"camera", motionToJson(report, drawing.name, Motion::Camera)},
          {"light", motionToJson(report, drawing.name, Motion::Light)},
          {"passes", passes},
          {"bytesStored", report.frames.bytes[i].stored},
          {"bytesUsed", report.frames.bytes[i].used}};
}

Json ratioToJson(const CostRatio& ratio) {
  Json row = {{"name", ratio.name}, {"value", nullptr}, {"goal", nullptr}, {"holds", nullptr}};
  if (!std::isnan(ratio.value)) row["value"] = ratio.value;
  if (ratio.goal) {
    row["goal"] = *ratio.goal;
    row["holds"] = ratio.holds();
  }
  if (!ratio.unit.empty()) row["unit"] = ratio.unit;
  return row;
}

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

// "112.3 (110.0 … 114.8)".
std::string spreadText(const Spread& spread) {
  return fixed(spread.median, 1) + " (" + fixed(spread.q1, 1) + " … " + fixed(spread.q3, 1) + ")";
}

TableRow motionsOf(const BenchReport& report, std::string_view name) {
  return {std::string(name), spreadText(spreadOf(report, name, nameOf(Motion::Camera))),
          spreadText(spreadOf(report, name, nameOf(Motion::Light)))};
}

std::string passesText(const BenchReport& report, std::size_t i) {
  std::string text;
  for (const std::string& pass : report.frames.passes[i])
    text += (text.empty() ? "" : " · ") + pass + " " +
            fixed(spreadOf(report, report.cases[i].name, pass).median, 1);
  return text;
}

std::string casesText(const BenchReport& report) {
  std::vector<TableRow> table{
      {"CASE", "CAMERA MOVES", "LIGHT MOVES", "BYTES STORED", "BYTES USED", "PASSES"}};
  for (Baseline baseline : baselineNames) table.push_back(motionsOf(report, nameOf(baseline)));
  for (std::size_t i = 0; i < report.cases.size(); ++i) {
    TableRow& row = table.emplace_back(motionsOf(report, report.cases[i].name));
    const CaseBytes& bytes = report.frames.bytes[i];
    row.insert(row.end(), {fixed(bytes.stored, 0), fixed(bytes.used, 1), passesText(report, i)});
  }
  const bool gpu = report.frames.clock == CostClock::Gpu;
  return tableText(table) + "\nMilliseconds of " +
         (gpu ? "GPU time" : "processor time of all threads") + ": median (quartiles) of " +
         std::to_string(report.frames.rounds) +
         " rounds. Passes are those of a frame after the light\nhas moved" +
         (gpu ? "" : ", each waited for, so that their sum may exceed the frame's") +
         ". Bytes are per texel of the shadow map: stored\nby the method (its channels), and used "
         "in all textures of the program.\n" +
         report.frames.renderer + ", " + report.scene + ", " + std::string(nameOf(report.light)) +
         " light" + ", " + std::to_string(report.width) + "x" + std::to_string(report.height) +
         "\n";
}

std::string ratiosText(const BenchReport& report) {
  bool goals = false;
  for (const CostRatio& ratio : report.ratios) goals = goals || ratio.goal;
  std::vector<TableRow> table{{"RATIO", "VALUE"}};
  if (goals) table.front().insert(table.front().end(), {"GOAL", ""});
  for (const CostRatio& ratio : report.ratios) {
    const std::string unit = ratio.unit.empty() ? "" : " " + ratio.unit;
    table.push_back({ratio.name, std::isnan(ratio.value) ? "-" : fixed(ratio.value, 2) + unit});
    if (ratio.goal)
      table.back().insert(table.back().end(),
                          {"≤ " + fixed(*ratio.goal, 2) + unit, ratio.holds() ? "" : "missed"});
  }
  return tableText(table);
}

}  // namespace

Json benchToJson(const BenchReport& report) {
  const FrameRoundsResult& frames = report.frames;
  Json object = {{"format", "umbrascope-bench/1"},
                 {"scene", report.scene},
                 {"light", nameOf(report.light)},
                 {"size", {report.width, report.height}},
                 {"renderer", frames.renderer},
                 {"rounds", frames.rounds},
                 {"clock", frames.clock == CostClock::Gpu ? "gpu" : "processor"},
                 {"cases", Json::array()},
                 {"baselines", Json::object()},
                 {"ratios", Json::array()}};
  for (std::size_t i = 0; i < report.cases.size(); ++i)
    object["cases"].push_back(caseToJson(report, i));
  for (Baseline baseline : baselineNames)
    object["baselines"][std::string(nameOf(baseline))] = {
        {"camera", motionToJson(report, nameOf(baseline), Motion::Camera)},
        {"light", motionToJson(report, nameOf(baseline), Motion::Light)}};
  for (const CostRatio& ratio : report.ratios) object["ratios"].push_back(ratioToJson(ratio));
  for (const std::string& name : report.analysis.names())
    object["analysis"][name] = quartilesToJson(report.analysis.spread(name));
  return object;
}

void writeBench(OutputFolder& folder, const BenchReport& report) {
  std::string csv =
      "name,cameraQ1,cameraMs,cameraQ3,lightQ1,lightMs,lightQ3,bytesStored,bytesUsed\n";
  const auto add = [&](std::string_view name, const std::string& bytes) {
    csv += name;
    for (Motion motion : {Motion::Camera, Motion::Light}) {
      const Spread spread = spreadOf(report, name, nameOf(motion));
      for (double value : {spread.q1, spread.median, spread.q3}) csv += "," + Json(value).dump();
    }
    csv += "," + bytes + "\n";
  };
  for (Baseline baseline : baselineNames) add(nameOf(baseline), ",");
  for (std::size_t i = 0; i < report.cases.size(); ++i) {
    const CaseBytes& bytes = report.frames.bytes[i];
    add(report.cases[i].name, Json(bytes.stored).dump() + "," + Json(bytes.used).dump());
  }
  writeTextAtomically(folder.file("bench.json"), toText(benchToJson(report)));
  writeTextAtomically(folder.file("bench.csv"), csv);
}

std::string benchText(const BenchReport& report) {
  return casesText(report) + "\n" + ratiosText(report);
}

}  // namespace umbra

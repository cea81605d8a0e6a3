#include "datasets/plans/SweepPlan.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>

#include "datasets/json/JsonText.h"
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/plans/SweepAxes.h"
#include "datasets/plans/SweepCell.h"
#include "datasets/session/file/JsonObject.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr SweepMeasure allMeasures[] = {SweepMeasure::Compare, SweepMeasure::Decomposition,
                                        SweepMeasure::Probe, SweepMeasure::Cost,
                                        SweepMeasure::Picture};

// Whether somebody asks for a storage format.
bool namesFormat(const SweepPlan& plan, const Json& base) {
  return base.is_string() || base.value("/frame/format"_json_pointer, Json()).is_string() ||
         std::find(plan.settings.begin(), plan.settings.end(), "map.format") != plan.settings.end();
}

Workspace baseFrom(const Json& value, const std::string& where, const fs::path& folder) {
  if (value.is_string()) return readWorkspace(folder / value.get<std::string>());
  if (!value.is_object())
    throw Error(ErrorKind::BadInput,
                where + ": " + quoted(value) + " should be a session, or the name of its file");
  Json session = value;
  if (!session.contains("format")) session["format"] = sessionFormat;
  Workspace base = workspaceFrom(session, where);
  SceneSource& source = base.shared.source;
  if (source.kind != SourceKind::Catalogue)
    source.name = (fs::absolute(folder) / source.name).lexically_normal().string();
  return base;
}

// FNV-1a: tells plans and files apart, and is the same on every machine.
class Fingerprint {
 public:
  void add(std::string_view text) {
    for (const char c : text) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  void addFile(const fs::path& file) {
    checkInput(file);
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> block(std::size_t(1) << 20);
    while (stream.read(block.data(), std::streamsize(block.size())), stream.gcount() > 0)
      add({block.data(), std::size_t(stream.gcount())});
    if (meshfile::mayReferToFiles(file)) addShape(meshfile::readRawMesh(file));
  }
  std::string text() const {
    char buffer[20];
    std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(hash_));
    return buffer;
  }

 private:
  void addShape(const meshfile::RawMesh& mesh) {
    const auto addAll = [this](const auto& values) {
      add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]});
    };
    addAll(mesh.positions);
    addAll(mesh.normals);
    addAll(mesh.triangles);
  }

  std::uint64_t hash_ = 14695981039346656037u;
};

// A plan and its files may be moved together, so that paths do not count.
std::string fingerprintOf(const SweepPlan& plan) {
  Workspace base = plan.base;
  if (base.shared.source.kind != SourceKind::Catalogue)
    base.shared.source.name = fs::path(base.shared.source.name).filename().string();
  Json whole{{"base", toJson(base)}, {"cells", plan.cells}, {"format", plan.namesFormat}};
  for (SweepMeasure measure : plan.measures) whole["measures"].push_back(nameOf(measure));
  Fingerprint fingerprint;
  fingerprint.add(whole.dump());
  for (const fs::path& file : plan.files) fingerprint.addFile(file);
  return fingerprint.text();
}

// Cells are checked before any is measured: a plan does not end at its last cell for a wrong name.
// Finds the files that they are measured of, whose content makes them, too.
void checkCells(SweepPlan& plan, const std::string& where, const std::function<void()>& between) {
  const TechniqueCatalogue catalogue = allTechniques();
  const auto asks = [&](SweepMeasure measure) {
    return std::find(plan.measures.begin(), plan.measures.end(), measure) != plan.measures.end();
  };
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const Session session = sessionOfCell(plan, i, catalogue, {}, where);
    const auto refuse = [&](const std::string& why) {
      throw Error(ErrorKind::BadInput, where + ": cell " + std::to_string(i) + ": " + why);
    };
    if (asks(SweepMeasure::Probe) && !session.probe)
      refuse("the measure 'probe' needs a 'probe' in the base");
    if (i % 256 == 255) between();
    if (session.source.kind != SourceKind::Catalogue) plan.files.insert(session.source.name);
    if (session.source.kind != SourceKind::DepthFile) continue;
    if (!session.receiver) refuse("a depth map needs a 'receiver', in the base or on an axis");
    for (SweepMeasure measure :
         {SweepMeasure::Decomposition, SweepMeasure::Cost, SweepMeasure::Picture})
      if (asks(measure))
        refuse("a depth map has no frame; '" + std::string(nameOf(measure)) +
               "' goes with a scene");
  }
}

// What follows from the rest.
void finish(SweepPlan& plan, const Json& base, std::string_view where, const fs::path& folder,
            const std::function<void()>& between) {
  plan.folder = folder;
  plan.namesFormat = namesFormat(plan, base);
  checkCells(plan, std::string(where), between);
  plan.fingerprint = fingerprintOf(plan);
}

}  // namespace

std::string_view nameOf(SweepMeasure measure) {
  switch (measure) {
    case SweepMeasure::Compare:
      return "compare";
    case SweepMeasure::Decomposition:
      return "decomposition";
    case SweepMeasure::Probe:
      return "probe";
    case SweepMeasure::Cost:
      return "cost";
    case SweepMeasure::Picture:
      break;
  }
  return "picture";
}

SweepMeasure sweepMeasureFrom(const Json& value, const std::string& where) {
  std::vector<std::string> names;
  for (SweepMeasure measure : allMeasures) {
    if (value == std::string(nameOf(measure))) return measure;
    names.emplace_back(nameOf(measure));
  }
  throw Error(ErrorKind::BadInput,
              where + ": " + quoted(value) + " is not right, it takes " + joined(names));
}

SweepPlan sweepPlanFrom(std::string_view text, std::string_view where, const fs::path& folder,
                        const std::function<void()>& between) {
  const Json json = jsonFromText(text, where);
  SweepPlan plan;
  JsonObject object(json, std::string(where));
  std::string format;
  object.read("format", format);
  if (format != sweepFormat)
    throw Error(ErrorKind::BadInput, std::string(where) + ": format: '" + clipped(format) +
                                         "' should be '" + sweepFormat + "'");
  object.readValue("base", [&](const Json& value, const std::string& at) {
    plan.base = baseFrom(value, at, folder);
  });
  readSweepAxes(object, plan);
  object.readList("measures", [&](const Json& value, const std::string& at) {
    plan.measures.push_back(sweepMeasureFrom(value, at));
  });
  if (plan.measures.empty()) plan.measures = {SweepMeasure::Compare};
  object.finish();
  finish(plan, json.value("base", Json::object()), where, folder, between);
  return plan;
}

SweepPlan sweepPlanOfCells(const Json& base, std::vector<SweepCell> cells,
                           std::vector<SweepMeasure> measures, std::string_view where,
                           const fs::path& folder) {
  SweepPlan plan;
  plan.base = baseFrom(base, std::string(where) + ": base", folder);
  for (const SweepCell& cell : cells)
    for (const auto& [setting, value] : cell)
      if (std::find(plan.settings.begin(), plan.settings.end(), setting) == plan.settings.end())
        plan.settings.push_back(setting);
  plan.cells = std::move(cells);
  plan.measures = std::move(measures);
  finish(plan, base, where, folder, [] {});
  return plan;
}

SweepPlan readSweepPlan(const fs::path& file, const std::function<void()>& between) {
  return sweepPlanFrom(textOf(file), file.string(), fs::absolute(file).parent_path(), between);
}

}  // namespace umbra

#include "app/sweep/SweepRunner.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "analysis/errors/CompareMap.h"
#include "analysis/errors/ErrorDecomposition.h"
#include "analysis/probe/Probe.h"
#include "app/frames/FrameDecomposition.h"
#include "app/frames/SceneCompare.h"
#include "app/frames/SceneProbe.h"
#include "app/frames/TechniqueSet.h"
#include "app/output/Cancellation.h"
#include "app/reports/Reports.h"
#include "datasets/plans/SweepCell.h"
#include "datasets/session/DepthReading.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

// The row of one technique, with the number of samples.
Json figuresToJson(const MetricsRow& row) {
  const Json all = compareToJson({row});
  Json figures{{"samples", all["samples"]}};
  figures.update(all["techniques"][0]);
  figures.erase("name");
  return figures;
}

Json probeToJson(const Probe& probe) {
  const TechniqueResult& result = probe.techniques[0];
  Json json{
      {"visibility", result.visibility}, {"reference", probe.reference}, {"error", result.error}};
  if (result.gpu) json["gpu"] = *result.gpu;
  return json;
}

}  // namespace

SweepRunner::SweepRunner(const SweepPlan& plan, std::string where, KeepPicture keepPicture)
    : plan_(plan), where_(std::move(where)), keepPicture_(std::move(keepPicture)) {}

SweepRunner::~SweepRunner() = default;

bool SweepRunner::asks(SweepMeasure measure) const {
  return std::find(plan_.measures.begin(), plan_.measures.end(), measure) != plan_.measures.end();
}

Json SweepRunner::measured(std::size_t cell) {
  throwIfCancelled();
  const SceneOf sceneOf = [this](const SceneSource& source) { return scenes_.scene(source); };
  const Session session = sessionOfCell(plan_, cell, catalogue_, sceneOf, where_);
  Json row{{"cell", cell}, {"settings", Json::object()}, {"technique", session.technique}};
  for (const auto& [setting, value] : plan_.cells[cell]) row["settings"][setting] = value;
  std::vector<std::string> notices;
  const std::shared_ptr<Technique> technique =
      techniqueOf(session, catalogue_, session.technique, &notices);
  const bool isMap = session.source.kind == SourceKind::DepthFile;
  std::string reason = whyImpossible(session.frame, *technique);
  if (reason.empty() && !isMap) reason = whyNoGpuFormat(session);
  if (!reason.empty()) {
    row["reason"] = reason;
    return row;
  }
  if (const std::string loss = whyReadInexactly(session, *technique); !loss.empty())
    notices.push_back(loss);
  // What was measured is not quite what the cell sets.
  if (!notices.empty()) {
    row["notices"] = notices;
    row["parameters"] = parametersOf(*technique);
    for (const std::string& notice : notices)
      if (said_.insert(notice).second) spdlog::warn("{}: {}", session.technique, notice);
  }
  if (isMap)
    measureMap(session, technique, row);
  else
    measureScene(session, technique, cell, row);
  return row;
}

void SweepRunner::measureMap(const Session& session, const std::shared_ptr<Technique>& technique,
                             Json& row) {
  if (mapSource_ != session.source) {
    map_.reset();
    map_ = loadedDepth(session.source);
    mapSource_ = session.source;
  }
  const DepthMap& map = map_->map;
  const FrameSettings frame = readSettingsOf(session);
  technique->adapt(map);
  const std::shared_ptr<const Technique> adapted = technique;
  if (asks(SweepMeasure::Compare)) {
    const auto figures = figuresOnMap(map, std::span(&adapted, 1), frame.kernel, frame.map.format,
                                      *session.receiver, throwIfCancelled);
    row["compare"] =
        figuresToJson({session.technique, figures[0].metrics, figures[0].reduction, {}, {}, {}});
  }
  if (!asks(SweepMeasure::Probe)) return;
  const auto [x, y] = *session.probe;
  if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) {
    row["reason"] = "the base's probe lies outside the map";
    return;
  }
  ProbeRequest request{.map = map,
                       .read = ReadPoint::atTexel(map, x, y),
                       .kernel = frame.kernel,
                       .format = frame.map.format,
                       .receiver = *session.receiver};
  request.techniques.push_back(adapted);
  const Probe probe = takeProbe(request);
  row["probe"] = probeToJson(probe);
  row["probe"]["texel"] = {x + map_->originX, y + map_->originY};
}

void SweepRunner::measureScene(const Session& session, const std::shared_ptr<Technique>& technique,
                               std::size_t cell, Json& row) {
  const std::shared_ptr<const Scene> scene = scenes_.scene(session.source);
  try {
    measureFrame(session, technique, scene, cell, row);
  } catch (const Error& error) {
    // A light that looks nowhere, a pixel that shows nothing: other cells may be sound.
    const bool isOfCell =
        error.kind() == ErrorKind::BadInput || error.kind() == ErrorKind::BadCommandLine;
    if (!isOfCell) throw;
    for (const char* measure : {"compare", "probe", "cost", "picture"}) row.erase(measure);
    row["reason"] = error.what();
    frame_.reset();
  }
}

void SweepRunner::measureFrame(const Session& session, const std::shared_ptr<Technique>& technique,
                               const std::shared_ptr<const Scene>& scene, std::size_t cell,
                               Json& row) {
  if (!display_) display_ = loadDisplay();
  if (frame_)
    frame_->show(scene, session);
  else
    frame_ = display_->makeFrame(scene, session);
  frame_->render(*technique, ViewMode::Shaded);
  if (const int samples = frame_->depthMap().channels(); samples != session.frame.map.samples)
    row["samplesUsed"] = samples;  // the driver has no more
  if (asks(SweepMeasure::Picture))
    row["picture"] = keepPicture_(cell, display_->pngOf(frame_->colour()));
  if (asks(SweepMeasure::Probe)) {
    const std::vector<std::shared_ptr<Technique>> probed{technique};
    row["probe"] = probeToJson(probeScene(*frame_, session, probed, *session.probe).probe);
  }
  if (asks(SweepMeasure::Cost)) {
    MetricsRow costs{session.technique, {}, {}, {}, {}, {}};
    costs.cost = frame_->cost(*technique);
    row["cost"] = compareToJson({costs})["techniques"][0]["cost"];
    frame_->render(*technique, ViewMode::Shaded);
  }
  if (!asks(SweepMeasure::Compare) && !asks(SweepMeasure::Decomposition)) return;
  std::optional<ErrorSums> parts;
  if (asks(SweepMeasure::Decomposition)) parts = sumsOf(decomposeFrame(*frame_).parts);
  throwIfCancelled();
  MetricsRow figures = compareFrame(*frame_, *technique);
  figures.decomposition = parts;
  row["compare"] = figuresToJson(figures);
}

}  // namespace umbra

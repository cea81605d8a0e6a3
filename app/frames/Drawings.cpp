#include "app/frames/Drawings.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "app/frames/TechniqueSet.h"
#include "datasets/session/DepthReading.h"
#include "datasets/session/PaneLabels.h"
#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SessionFileParameters.h"
#include "datasets/session/file/SessionFileSettings.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

std::string labelOf(const Technique& technique, const std::string& differences) {
  const std::string title(technique.info().title);
  return differences.empty() ? title : title + " · " + differences;
}

void addDifferences(std::vector<Drawing>& drawings) {
  std::vector<std::map<std::string, Json>> values;
  for (const Drawing& drawing : drawings) values.push_back(valuesOf(drawing));
  for (std::size_t i = 0; i < drawings.size(); ++i)
    for (const auto& [name, value] : values[i]) {
      const auto differs = [&, &name = name, &value = value](const auto& others) {
        const auto other = others.find(name);
        return other != others.end() && other->second != value;
      };
      if (std::any_of(values.begin(), values.end(), differs)) drawings[i].differences[name] = value;
    }
}

void addNames(std::vector<Drawing>& drawings) {
  for (Drawing& drawing : drawings) {
    const std::string_view id = drawing.technique->info().id;
    const auto same = std::count_if(drawings.begin(), drawings.end(), [&](const Drawing& other) {
      return other.technique->info().id == id;
    });
    drawing.name = std::string(id) + (same > 1 ? "-" + std::to_string(drawing.pane) : "");
  }
}

std::vector<Drawing> unnamedPanes(const Workspace& workspace, const TechniqueCatalogue& catalogue) {
  std::vector<Drawing> panes;
  const std::vector<std::string> labels = paneLabels(workspace, catalogue);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Session session = sessionOfPane(workspace, i);
    session.frame = readSettingsOf(session);
    std::shared_ptr<Technique> technique = techniqueOf(session, catalogue, session.technique);
    std::string refusal = whyImpossible(session.frame, *technique);
    if (refusal.empty())
      technique = makeTechniques(session, catalogue, {{session.technique}}).front();
    std::string label = labelOf(*technique, labels[i]);
    panes.push_back({std::move(session), std::move(technique), std::move(label), {}, i + 1});
    panes.back().refusal = std::move(refusal);
  }
  return panes;
}

}  // namespace

std::map<std::string, Json> valuesOf(const Drawing& drawing) {
  std::map<std::string, Json> values;
  FrameSettings frame = drawing.session.frame;
  for (const Setting& setting : settingsOf(frame))
    if (setting.info.pane)
      values[std::string(setting.info.name)] = toJson(setting.info, setting.get());
  const Technique& technique = *drawing.technique;
  for (const ParameterView& parameter : technique.parameters())
    values[std::string(technique.info().id) + "." + std::string(parameter.name)] =
        toJson(parameter.get());
  return values;
}

std::vector<Drawing> drawingsOf(const Session& session,
                                const std::vector<std::shared_ptr<Technique>>& techniques) {
  std::vector<Drawing> drawings;
  for (const auto& technique : techniques)
    drawings.push_back({session, technique, std::string(technique->info().title), {}});
  addNames(drawings);
  return drawings;
}

std::vector<Drawing> panesOf(const Workspace& workspace, const TechniqueCatalogue& catalogue) {
  std::vector<Drawing> panes = unnamedPanes(workspace, catalogue);
  addNames(panes);
  addDifferences(panes);
  return panes;
}

std::vector<Drawing> drawingsOfPanes(const Workspace& workspace,
                                     const TechniqueCatalogue& catalogue) {
  std::vector<Drawing> panes = unnamedPanes(workspace, catalogue);
  const auto refused = [](const Drawing& pane) { return !pane.refusal.empty(); };
  const bool some = !std::all_of(panes.begin(), panes.end(), refused);
  for (const Drawing& pane : panes) {
    if (!refused(pane)) continue;
    if (some && workspace.comparison.mode == ComparisonMode::Grid)
      spdlog::warn("left out: {}", pane.refusal);
    else
      makeTechniques(pane.session, catalogue, {{pane.session.technique}});  // throws
  }
  std::erase_if(panes, refused);
  addNames(panes);
  addDifferences(panes);
  return panes;
}

}  // namespace umbra

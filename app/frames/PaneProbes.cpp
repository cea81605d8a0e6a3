#include "app/frames/PaneProbes.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/output/Cancellation.h"
#include "app/output/Table.h"
#include "app/reports/Reports.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

PaneProbe probePane(const Drawing& pane, const std::function<TakenProbe()>& take) {
  throwIfCancelled();
  PaneProbe result{pane, {}, {}, pane.refusal};
  if (!result.reason.empty()) return result;
  try {
    auto [probe, json] = take();
    result.probe = std::move(probe);
    result.json = std::move(json);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::Cancelled) throw;
    result.reason = error.what();
  }
  return result;
}

Json panesToJson(const std::vector<PaneProbe>& panes) {
  Json list = Json::array();
  for (const PaneProbe& pane : panes) {
    Json object{{"pane", pane.drawing.pane}, {"settings", pane.drawing.differences}};
    for (const auto& [key, value] : pane.json.items())
      if (key != "format" && key != "source") object[key] = value;
    if (!pane.probe) object["reason"] = pane.reason;
    list.push_back(std::move(object));
  }
  return list;
}

std::string panesText(const std::vector<PaneProbe>& panes) {
  std::vector<TableRow> rows{{"PANE", "REFERENCE", "VISIBILITY", "ERROR"}};
  for (const PaneProbe& pane : panes) {
    const Drawing& drawing = pane.drawing;
    rows.push_back({rowName(drawing.technique->info().id, drawing.pane, drawing.differences)});
    if (!pane.probe) {
      rows.back().insert(rows.back().end(), {pane.reason, "", ""});
      continue;
    }
    const TechniqueResult& result = pane.probe->techniques.front();
    for (const double figure : {pane.probe->reference, result.visibility, result.error})
      rows.back().push_back(shortNumber(figure));
  }
  return tableText(rows);
}

}  // namespace umbra

#include "app/reports/SurfaceReport.h"

#include <nlohmann/json.hpp>

#include "app/output/Table.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {
namespace {

Json worstToJson(const std::optional<WorstPlace>& worst) {
  if (!worst) return nullptr;
  const Eigen::Vector3d& p = worst->position;
  return {{"position", {p.x(), p.y(), p.z()}}, {"error", worst->error}};
}

void addSums(Json& object, const SurfaceSums& sums) {
  object["area"] = sums.area;
  object["shadowedArea"] = sums.shadowedArea;
  object["bleedingArea"] = sums.bleedingArea;
  object["meanBleeding"] = sums.meanBleeding;
  object["worst"] = worstToJson(sums.worst);
  object["faces"] = sums.faces;
}

std::string placeText(const std::optional<WorstPlace>& worst) {
  if (!worst) return "-";
  const Eigen::Vector3d& p = worst->position;
  return shortNumber(p.x()) + "," + shortNumber(p.y()) + "," + shortNumber(p.z());
}

}  // namespace

Json surfacesToJson(const SurfaceSummary& summary) {
  Json object = Json::object(), objects = Json::array();
  addSums(object, summary.all);
  object["edge"] = summary.edge;
  object["visibleFrom"] = visibleError;
  for (const SurfaceSums& sums : summary.objects) {
    Json row = {{"name", sums.name}};
    addSums(row, sums);
    objects.push_back(row);
  }
  object["objects"] = objects;
  return object;
}

std::string surfacesText(const std::vector<MetricsRow>& rows) {
  std::vector<TableRow> table{
      {"TECHNIQUE", "AREA", "SHADOWED", "BLEEDING AREA", "MEAN BLEEDING", "WORST", "AT X,Y,Z"}};
  for (const MetricsRow& row : rows) {
    if (!row.surfaces) continue;
    const SurfaceSums& all = row.surfaces->all;
    table.push_back({nameOf(row), shortNumber(all.area), shortNumber(all.shadowedArea),
                     shortNumber(all.bleedingArea), shortNumber(all.meanBleeding),
                     all.worst ? shortNumber(all.worst->error) : "-", placeText(all.worst)});
  }
  return table.size() > 1 ? "\n" + tableText(table) : "";
}

}  // namespace umbra

#include "app/reports/CompareFiles.h"

#include <nlohmann/json.hpp>

#include "app/output/Table.h"
#include "app/reports/SurfaceReport.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// A second table of what each technique's mean error consists of; "" where nobody asked for it.
std::string decompositionText(const std::vector<MetricsRow>& rows) {
  std::vector<TableRow> table{{"TECHNIQUE", "ERROR"}};
  for (int i = 0; i < errorPartCount; ++i) {
    std::string heading;
    for (const char letter : nameOf(ErrorPart(i))) {  // "contactLeak" is "CONTACT LEAK"
      if (letter >= 'A' && letter <= 'Z') heading += ' ';
      heading += letter >= 'a' ? char(letter - 'a' + 'A') : letter;
    }
    table.front().push_back(heading);
  }
  const bool againstRays = !rows.empty() && rows.front().mapError;
  if (againstRays) table.front().push_back("MAP");
  for (const MetricsRow& row : rows) {
    if (!row.decomposition) continue;
    const double error = row.decomposition->error + row.mapError.value_or(0.0);
    table.push_back({nameOf(row), shortNumber(error)});
    for (double mean : row.decomposition->means) table.back().push_back(shortNumber(mean));
    if (againstRays) table.back().push_back(shortNumber(*row.mapError));
  }
  return table.size() > 1 ? "\n" + tableText(table) : "";
}

}  // namespace

void writeCompare(OutputFolder& folder, const Json& object) {
  std::string csv;
  for (const Json& row : object["techniques"]) {
    std::string heading, line;
    const auto add = [&](const std::string& name, const Json& value) {
      const std::string comma = line.empty() ? "" : ",";
      heading += comma + name;
      line += comma + (value.is_string() ? value.get<std::string>() : value.dump());
    };
    for (const auto& [name, value] : row.items()) {
      if (name == "cost")
        for (const auto& [part, figure] : value.items()) add(part, figure);
      else if (!value.is_object())  // not every technique has a smallest reduction
        add(name, value);
    }
    if (csv.empty()) csv = heading + "\n";
    csv += line + "\n";
  }
  writeTextAtomically(folder.file("compare.json"), toText(object));
  writeTextAtomically(folder.file("compare.csv"), csv);
}

std::string compareText(const std::vector<MetricsRow>& rows) {
  std::vector<TableRow> table{
      {"TECHNIQUE", "RMSE", "MAE", "BLEEDING", "DARKENING", "MAX", "MIN", "UMBRA BLEEDING"}};
  const bool drawn = !rows.empty() && rows.front().cost;
  if (drawn)
    table.front().insert(table.front().end(),
                         {"BAKE MS", "SHADE MS", "BYTES STORED", "BYTES USED"});
  for (const MetricsRow& row : rows) {
    const Metrics& m = row.metrics;
    table.push_back({nameOf(row), shortNumber(m.rmse), shortNumber(m.mae), shortNumber(m.bleeding),
                     shortNumber(m.darkening), shortNumber(m.max), shortNumber(m.min),
                     shortNumber(m.umbraBleeding)});
    if (row.cost)
      for (double figure :
           {row.cost->bakeMs, row.cost->shadeMs, row.cost->bytesStored, row.cost->bytesUsed})
        table.back().push_back(shortNumber(figure));
  }
  const std::size_t samples = rows.empty() ? 0 : rows.front().metrics.samples;
  return tableText(table) + decompositionText(rows) + surfacesText(rows) + "\n" +
         std::to_string(samples) + " samples\n" +
         (drawn ? "Bytes are per texel of the shadow map: stored by the method, and used in all "
                  "textures of the\nprogram. Milliseconds are medians of three frames or fewer; "
                  "`bench` measures them with their spread.\n"
                : "");
}

}  // namespace umbra

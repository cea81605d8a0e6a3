#include "analysis/plots/Plot.h"

#include <algorithm>
#include <charconv>

#include "filters/core/support/AtomicFile.h"

namespace umbra {
namespace {

struct Column {
  std::string header;
  const std::vector<double>* values;
};

std::vector<Column> columnsOf(const Plot& plot) {
  std::vector<Column> columns;
  const std::vector<double>* sharedX = nullptr;
  for (const PlotSeries& series : plot.series) {
    if (!sharedX || *sharedX != series.x) {
      columns.push_back({plot.xLabel, &series.x});
      sharedX = &series.x;
    }
    columns.push_back({series.name.empty() ? plot.yLabel : series.name, &series.y});
  }
  return columns;
}

// RFC 4180: quoted where needed, quotes doubled.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

void appendNumber(std::string& text, double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

}  // namespace

std::string toCsv(const Plot& plot) {
  const std::vector<Column> columns = columnsOf(plot);
  std::size_t rows = 0;
  std::string text;
  for (const Column& column : columns) {
    if (!text.empty()) text += ',';
    text += quoted(column.header);
    rows = std::max(rows, column.values->size());
  }
  text += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ',';
      if (row < columns[c].values->size()) appendNumber(text, (*columns[c].values)[row]);
    }
    text += '\n';
  }
  return text;
}

void writeCsv(const Plot& plot, const std::filesystem::path& file) {
  writeTextAtomically(file, toCsv(plot));
}

}  // namespace umbra

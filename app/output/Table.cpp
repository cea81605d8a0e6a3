#include "app/output/Table.h"

#include <algorithm>

namespace umbra {
namespace {

// UTF-8 continuation bytes take no column.
std::size_t widthOf(const std::string& text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool isNumber(const std::string& text) {
  return text.empty() || text == "-" ||
         text.find_first_not_of("+-.0123456789eE") == std::string::npos;
}

}  // namespace

std::string tableText(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths;
  std::vector<bool> numeric;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      if (c >= widths.size()) {
        widths.push_back(0);
        numeric.push_back(true);
      }
      widths[c] = std::max(widths[c], widthOf(rows[r][c]));
      if (r > 0) numeric[c] = numeric[c] && isNumber(rows[r][c]);
    }
  std::string text;
  for (const TableRow& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string space(widths[c] - widthOf(row[c]), ' ');
      line += (c ? "  " : "") + (numeric[c] ? space + row[c] : row[c] + space);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace umbra

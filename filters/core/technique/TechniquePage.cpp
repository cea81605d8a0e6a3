#include "filters/core/technique/TechniquePage.h"

#include <algorithm>
#include <vector>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// A bar in a text would end the table's cell, so it is escaped.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string tableOf(std::string_view id, const std::vector<ParameterView>& parameters) {
  std::string table =
      "**Parameters**\n\n| name | symbol | unit | range | default | meaning |\n"
      "|---|---|---|---|---|---|\n";
  for (const ParameterView& p : parameters) {
    table += "| `" + std::string(id) + "." + std::string(p.name) + "` |";
    for (const std::string& text : {std::string(p.symbol), std::string(p.unit), rangeText(p),
                                    toText(p.defaultValue), std::string(p.doc)})
      table += " " + cell(text) + " |";
    table += "\n";
  }
  return table + "\n";
}

}  // namespace

std::string rangeText(const ParameterView& parameter) {
  if (parameter.choices.empty())
    return shortNumber(parameter.low) + " … " + shortNumber(parameter.high);
  const std::vector<std::string> names(parameter.choices.begin(), parameter.choices.end());
  return joined(names, "|");
}

std::string pageOf(const Technique& technique) {
  std::string page(technique.page());
  const std::vector<ParameterView> parameters = technique.parameters();
  if (parameters.empty()) return page;
  const std::size_t source = std::min(page.rfind("Source:"), page.size());
  return page.insert(source, tableOf(technique.info().id, parameters));
}

std::vector<std::string> pictureNames(std::string_view page) {
  std::vector<std::string> names;
  for (std::size_t at = page.find("!["); at != page.npos; at = page.find("![", at + 1)) {
    const std::size_t open = page.find("](", at), close = page.find(')', open);
    if (open == page.npos || close == page.npos) break;
    names.emplace_back(page.substr(open + 2, close - open - 2));
  }
  return names;
}

}  // namespace umbra

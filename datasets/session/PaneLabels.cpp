#include "datasets/session/PaneLabels.h"

#include <algorithm>

#include "filters/core/settings/SettingsTable.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// Holds one setting's text for every pane; a text is empty where the setting does nothing in a
// pane.
using Column = std::vector<std::string>;

// Puts the number in place of #, and leaves out the plural's s after a count of one.
std::string withNumber(std::string_view pattern, double number) {
  std::string text(pattern);
  text.replace(text.find('#'), 1, shortNumber(number));
  if (pattern.starts_with('#') && number == 1.0 && text.ends_with('s')) text.pop_back();
  return text;
}

std::string labelOf(const SettingRow<FrameSettings>& row, const FrameSettings& frame) {
  const SettingInfo& info = row.info;
  if (!info.pane || row.idleIn(frame)) return {};
  const SettingValue value = row.valueIn(frame);
  std::size_t which = 0;
  if (const auto* name = std::get_if<std::string>(&value))
    which = std::size_t(std::find(info.choices.begin(), info.choices.end(), *name) -
                        info.choices.begin());
  else if (const bool* on = std::get_if<bool>(&value))
    which = *on;
  else if (const auto* list = std::get_if<std::vector<double>>(&value))
    which = !list->empty();
  else if (const double* real = std::get_if<double>(&value))
    return *real == 0.0 && !info.automatic.empty() ? "" : withNumber(info.labels[0], *real);
  else
    return withNumber(info.labels[0], std::get<int>(value));
  return std::string(info.labels[which]);
}

// Makes a column for each setting that a pane may have of its own, except for those whose label
// continues the one before.
std::vector<Column> frameColumns(const std::vector<Session>& panes) {
  std::vector<Column> columns;
  for (const auto& row : frameTable()) {
    if (!row.info.pane) continue;
    const bool goesOn = row.info.labels[0].starts_with(' ');
    if (!goesOn) columns.emplace_back(panes.size());
    for (std::size_t i = 0; i < panes.size(); ++i) {
      columns.back()[i] += labelOf(row, panes[i].frame);
    }
  }
  return columns;
}

// Where more than half of them have the same text, that goes without saying.
void addWhereDifferent(std::vector<std::string>& labels, const Column& column,
                       std::vector<std::size_t> rows) {
  std::erase_if(rows, [&](std::size_t row) { return column[row].empty(); });
  for (const std::size_t row : rows) {
    const auto alike = std::count_if(
        rows.begin(), rows.end(), [&](std::size_t other) { return column[other] == column[row]; });
    if (2 * std::size_t(alike) > rows.size()) continue;
    labels[row] += (labels[row].empty() ? "" : " · ") + column[row];
  }
}

// "bleed reduction 0.3", as it was set, whatever a storage format makes of it.
std::string parameterText(const Parameter& parameter, const ParameterValues& set) {
  std::string name(parameter.name);
  std::replace(name.begin(), name.end(), '-', ' ');
  const auto found = set.find(std::string(parameter.name));
  const ParameterValue& value = found == set.end() ? parameter.defaultValue : found->second;
  const auto* real = std::get_if<double>(&value);
  const std::string text = real ? shortNumber(*real) : toText(value);
  return name + " " + (text.empty() ? "none" : text);
}

void addParameters(std::vector<std::string>& labels, const std::vector<Session>& panes,
                   const TechniqueCatalogue& catalogue) {
  std::vector<std::vector<std::string>> texts;  // of every pane, its parameters
  for (const Session& pane : panes) {
    const std::unique_ptr<Technique> technique = catalogue.make(pane.technique);
    const ParameterValues set = parametersOf(pane, pane.technique);
    std::vector<std::string>& own = texts.emplace_back();
    for (const Parameter& parameter : technique->parameters())
      own.push_back(parameterText(parameter, set));
  }
  std::vector<bool> done(panes.size(), false);
  for (std::size_t first = 0; first < panes.size(); ++first) {
    std::vector<std::size_t> alike;  // panes of one technique
    for (std::size_t i = first; i < panes.size(); ++i)
      if (!done[i] && panes[i].technique == panes[first].technique) alike.push_back(i);
    for (const std::size_t i : alike) done[i] = true;
    for (std::size_t p = 0; alike.size() > 1 && p < texts[first].size(); ++p) {
      Column column(panes.size());
      for (const std::size_t i : alike) column[i] = texts[i][p];
      addWhereDifferent(labels, column, alike);
    }
  }
}

}  // namespace

std::vector<std::string> paneLabels(const Workspace& workspace,
                                    const TechniqueCatalogue& catalogue) {
  std::vector<Session> panes;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < shownPanes(comparisonOf(workspace)); ++i) {
    panes.push_back(sessionOfPane(workspace, i));
    all.push_back(i);
  }
  std::vector<std::string> labels(panes.size());
  addParameters(labels, panes, catalogue);
  for (const Column& column : frameColumns(panes)) addWhereDifferent(labels, column, all);
  return labels;
}

}  // namespace umbra

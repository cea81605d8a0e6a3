#include "app/bench/GoalTable.h"

#include <algorithm>

#include "app/bench/AnalysisTimes.h"
#include "datasets/session/SessionSettings.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr GoalCase goalCases[] = {
    {"vsm", "vsm", ""},
    {"evsm4", "evsm4", ""},
    {"lvsm-2", "lvsm", "lvsm.layers=2"},
    {"lvsm-8", "lvsm", "lvsm.layers=8"},
    {"lvsm-16", "lvsm", "lvsm.layers=16"},
    {"lvsm-lloyd-2", "lvsm", "lvsm.layers=2 lvsm.placement=lloyd"},
    {"lvsm-lloyd-8", "lvsm", "lvsm.layers=8 lvsm.placement=lloyd"},
    {"csm-4", "csm", "csm.terms=4"},
    {"csm-16", "csm", "csm.terms=16"},
    {"vsm-2048", "vsm", "map.size=2048"},
    {"power-cdf-2048", "power-cdf", "map.size=2048"},
    {"power-cdf-half-2048", "power-cdf", "map.size=2048 map.format=half"},
    {"vsm-gaussian-2", "vsm", "kernel.shape=gaussian kernel.radius=2"},
    {"vsm-gaussian-32", "vsm", "kernel.shape=gaussian kernel.radius=32"},
    {"vsm-sat", "vsm", "read.filter=sat"},
};

constexpr CostGoal goalTable[] = {
    {"vsm camera", "noShadow camera", 1.10, "", "what shadows add to a frame that bakes nothing"},
    {"vsm light", "vtkShadowMapPass light", 1.00, "",
     "with a blur, against VTK's pass, which never blurs"},
    {"lvsm-8 shade", "lvsm-2 shade", 1.05, "", "a pixel reads one layer (Lauritzen 2008, 4.1)"},
    {"lvsm-16 shade", "lvsm-2 shade", 1.05, "", "the same"},
    {"lvsm-lloyd-8 light", "lvsm-lloyd-2 light", 1.5, "", "1.73 in Lauritzen 2008"},
    {"csm-16 light", "csm-4 light", 2.2, "", "2.43 in Annen 2007"},
    {"evsm4 light", "vsm light", 1.2, "", "four moments against two"},
    {"power-cdf-half-2048 light", "vsm-2048 light", 0.9, "", "0.89 in Gumbau 2011, table 1"},
    {"power-cdf-2048 light", "vsm-2048 light", 1.2, "", "1.73 in Gumbau 2011, table 1"},
    {"vsm-gaussian-32 light", "vsm-gaussian-2 light", 1.5, "", "linear by definition"},
    {"vsm-sat sums", "vsm prefilter", 3.0, "", "the table's build against one separable blur"},
    {compare2048, "", 1.5, "s", "every technique on a depth map, on every core"},
    {compare4096Work, compare2048Work, 4.3, "", "four times as many texels"},
    {probe65, "", 3.0, "ms",
     "65 x 65 taps, every technique, curves of 512 samples, less an empty probe"},
};

// Sets "kernel.radius=32 lvsm.layers=8". A mistake in the table is a mistake of the program.
void apply(std::string_view settings, Session& session, const TechniqueCatalogue& catalogue) {
  for (const std::string& setting : split(std::string(settings), ' ')) {
    const std::size_t equals = setting.find('='), dot = setting.find('.');
    const std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
    const std::string id = name.substr(0, dot);
    if (!catalogue.has(id)) {
      const std::vector<Setting> rows = settingsOf(session);
      settingNamed(rows, name, name).setFromText(value, name);
      continue;
    }
    editParameters(session, catalogue, id, [&](std::span<const Parameter> parameters) {
      parameterNamed(parameters, name.substr(dot + 1), name).setFromText(value, name);
    });
  }
}

// Whether a measurement, such as "vsm light", is of this case.
bool isOf(std::string_view measurement, std::string_view name) {
  return measurement.size() > name.size() && measurement.starts_with(name) &&
         measurement[name.size()] == ' ';
}

// Whether a measurement is of one of these techniques, or a baseline's.
bool isAmong(std::string_view measurement, std::span<const std::string> techniques) {
  const std::string_view name = measurement.substr(0, measurement.find(' '));
  if (name.empty() || name == "noShadow" || name == "vtkShadowMapPass") return true;
  for (const GoalCase& row : goalCases)
    if (row.name == name)
      return std::find(techniques.begin(), techniques.end(), row.technique) != techniques.end();
  return false;
}

}  // namespace

std::span<const CostGoal> allGoals() {
  return goalTable;
}

Session goalSession() {
  Session session;
  session.source.name = "car";
  session.frame.kernel = {KernelShape::Box, 2};
  return session;
}

std::vector<CostGoal> goalsNamed(std::span<const std::string> texts,
                                 std::span<const std::string> techniques) {
  std::vector<CostGoal> goals;
  for (const CostGoal& goal : goalTable) {
    const std::string name = nameOf(goal);
    const bool named = texts.empty() || std::any_of(texts.begin(), texts.end(), [&](auto& text) {
                         return name.find(text) != std::string::npos;
                       });
    if (named && (techniques.empty() ||
                  (isAmong(goal.numerator, techniques) && isAmong(goal.denominator, techniques))))
      goals.push_back(goal);
  }
  if (!goals.empty()) return goals;
  std::vector<std::string> names;
  for (const CostGoal& goal : goalTable) names.push_back("'" + nameOf(goal) + "'");
  throw Error(ErrorKind::BadCommandLine, std::string(texts.empty() ? "--technique" : "--goal") +
                                             ": no goal is left, there are " + joined(names));
}

bool asksFor(std::span<const CostGoal> goals, std::string_view measurement) {
  return std::any_of(goals.begin(), goals.end(), [&](const CostGoal& goal) {
    return goal.numerator == measurement || goal.denominator == measurement;
  });
}

std::vector<Drawing> casesOf(std::span<const CostGoal> goals, const Session& base,
                             const TechniqueCatalogue& catalogue) {
  std::vector<Drawing> cases;
  for (const GoalCase& row : goalCases) {
    const bool asked = std::any_of(goals.begin(), goals.end(), [&](const CostGoal& goal) {
      return isOf(goal.numerator, row.name) || isOf(goal.denominator, row.name);
    });
    if (!asked) continue;
    Drawing& drawing = cases.emplace_back(Drawing{base, nullptr, "", std::string(row.name)});
    apply(row.settings, drawing.session, catalogue);
    drawing.session.technique = row.technique;
    drawing.technique = techniqueOf(drawing.session, catalogue, drawing.session.technique);
    drawing.label = drawing.name;
  }
  return cases;
}

}  // namespace umbra

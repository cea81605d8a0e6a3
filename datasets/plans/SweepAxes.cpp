#include "datasets/plans/SweepAxes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "datasets/json/JsonText.h"
#include "datasets/plans/SweepCell.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refusePlan(const std::string& where, const std::string& right) {
  throw Error(ErrorKind::BadInput, where + ": " + right);
}

// What a cell must have: each setting one of some values, as tables have them, so that "on" is
// true.
using Condition = std::vector<std::pair<std::string, std::vector<std::string>>>;

Condition conditionFrom(const Json& value, const std::string& where) {
  if (!value.is_object() || value.empty())
    refusePlan(where, quoted(value) + " should be an object of settings and their values");
  Condition condition;
  for (const auto& [setting, wanted] : value.items()) {
    std::vector<std::string> texts;
    if (!wanted.is_array()) texts.push_back(textOfValue(wanted));
    for (const Json& one : wanted.is_array() ? wanted : Json::array())
      texts.push_back(textOfValue(one));
    if (texts.empty()) refusePlan(where + "." + setting, "names no value");
    condition.emplace_back(setting, texts);
  }
  return condition;
}

bool matches(const SweepCell& cell, const Condition& condition) {
  return std::all_of(condition.begin(), condition.end(), [&](const auto& wanted) {
    const auto found = std::find_if(cell.begin(), cell.end(),
                                    [&](const auto& one) { return one.first == wanted.first; });
    return found != cell.end() && std::find(wanted.second.begin(), wanted.second.end(),
                                            textOfValue(found->second)) != wanted.second.end();
  });
}

// One axis, or several that are stepped together: what each step sets.
struct Axis {
  std::vector<SweepCell> steps;
  Condition when;  // empty: always
};

// What a person would write: 1e-06, not 9.999999999999997e-07.
double inFifteenDigits(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.15g", value);
  double read = value;
  std::from_chars(buffer, buffer + std::strlen(buffer), read);
  return read;
}

// "range" and "log": from, to and how many, both ends among them.
std::vector<Json> valuesBetween(const Json& value, const std::string& where, bool isLog) {
  const bool isRight = value.is_array() && value.size() == 3 && value[0].is_number() &&
                       value[1].is_number() && value[2].is_number_unsigned();
  if (!isRight) refusePlan(where, quoted(value) + " should be [FROM, TO, COUNT]");
  const double from = value[0], to = value[1];
  const auto count = value[2].get<std::size_t>();
  if (count < 1 || count > mostCells)
    refusePlan(where, "the count should be from 1 to " + std::to_string(mostCells));
  if (isLog && (from <= 0.0 || to <= 0.0)) refusePlan(where, "both ends should be above 0");
  std::vector<Json> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = count > 1 ? double(i) / double(count - 1) : 0.0;
    // The ends are those that were written, to the last digit.
    const double between =
        i == 0 ? from
        : i + 1 == count
            ? to
            : inFifteenDigits(isLog ? from * std::pow(to / from, part) : from + part * (to - from));
    constexpr double mostCounted = 0x1p53;  // up to here doubles hold every whole number
    const bool isWhole = !isLog && value[0].is_number_integer() && value[1].is_number_integer() &&
                         between == std::round(between) && std::abs(between) <= mostCounted;
    values.push_back(isWhole ? Json(std::int64_t(between)) : Json(between));
  }
  return values;
}

Axis axisFrom(const Json& value, const std::string& where);

Axis zipped(const std::vector<Axis>& axes, const std::string& where) {
  Axis together;
  for (const Axis& axis : axes) {
    if (!axis.when.empty()) refusePlan(where, "axes that are stepped together have no 'when'");
    if (axis.steps.size() != axes.front().steps.size())
      refusePlan(where, "axes that are stepped together should have as many values each, not " +
                            std::to_string(axes.front().steps.size()) + " and " +
                            std::to_string(axis.steps.size()));
    together.steps.resize(axis.steps.size());
    for (std::size_t i = 0; i < axis.steps.size(); ++i)
      together.steps[i].insert(together.steps[i].end(), axis.steps[i].begin(), axis.steps[i].end());
  }
  return together;
}

Axis axisFrom(const Json& value, const std::string& where) {
  JsonObject object(value, where);
  Axis axis;
  std::string setting;
  std::vector<Axis> parts;
  int forms = 0;
  object.read("setting", setting);
  const auto take = [&](const std::vector<Json>& values) {
    ++forms;
    for (const Json& one : values) axis.steps.push_back({{setting, one}});
  };
  object.readValue("values", [&](const Json& values, const std::string& at) {
    if (!values.is_array() || values.empty())
      refusePlan(at, quoted(values) + " should be a list of values");
    take({values.begin(), values.end()});
  });
  object.readValue("range", [&](const Json& range, const std::string& at) {
    take(valuesBetween(range, at, false));
  });
  object.readValue("log", [&](const Json& range, const std::string& at) {
    take(valuesBetween(range, at, true));
  });
  object.readList(
      "zip", [&](const Json& one, const std::string& at) { parts.push_back(axisFrom(one, at)); });
  forms += !parts.empty();
  object.readValue(
      "when", [&](const Json& one, const std::string& at) { axis.when = conditionFrom(one, at); });
  object.finish();
  if (forms != 1) refusePlan(where, "should have one of 'values', 'range', 'log' and 'zip'");
  if (setting.empty() == parts.empty())
    refusePlan(where, parts.empty() ? "has no 'setting'" : "has both 'setting' and 'zip'");
  if (!parts.empty()) axis.steps = zipped(parts, where).steps;
  return axis;
}

// A condition on what nothing sets, or on a value that nothing takes, would never hold, without a
// word.
void checkKnown(const Condition& condition, const std::vector<Axis>& axes, const std::string& where,
                const std::string& who) {
  for (const auto& [setting, wanted] : condition) {
    std::vector<std::string> taken;
    for (const Axis& axis : axes)
      for (const SweepCell& step : axis.steps)
        for (const auto& [name, value] : step)
          if (name == setting) taken.push_back(textOfValue(value));
    if (taken.empty()) refusePlan(where, who + " sets '" + clipped(setting) + "'");
    for (const std::string& value : wanted)
      if (std::find(taken.begin(), taken.end(), value) == taken.end())
        refusePlan(where, who + " sets '" + clipped(setting) + "' to '" + clipped(value) +
                              "'; it takes " + clipped(joined(taken)));
  }
}

void addSettings(const Axis& axis, std::vector<std::string>& settings, const std::string& where) {
  for (const auto& [setting, value] : axis.steps.front()) {
    if (std::find(settings.begin(), settings.end(), setting) != settings.end())
      refusePlan(where, "two axes set '" + clipped(setting) + "'");
    settings.push_back(setting);
  }
}

// Every combination, the last axis fastest.
std::vector<SweepCell> product(const std::vector<Axis>& axes, const std::string& where) {
  std::vector<SweepCell> cells{{}};
  for (const Axis& axis : axes) {
    std::vector<SweepCell> next;
    for (const SweepCell& cell : cells) {
      if (!axis.when.empty() && !matches(cell, axis.when)) {
        next.push_back(cell);
        continue;
      }
      for (const SweepCell& step : axis.steps) {
        next.push_back(cell);
        next.back().insert(next.back().end(), step.begin(), step.end());
      }
      if (next.size() > mostCells)
        refusePlan(where, "has more than " + std::to_string(mostCells) + " cells");
    }
    cells = std::move(next);
  }
  return cells;
}

}  // namespace

void readSweepAxes(JsonObject& object, SweepPlan& plan) {
  std::vector<Axis> axes;
  object.readList("axes", [&](const Json& value, const std::string& where) {
    const Axis axis = axisFrom(value, where);
    checkKnown(axis.when, axes, where + ".when", "no earlier axis");
    addSettings(axis, plan.settings, where);
    axes.push_back(axis);
  });
  if (axes.empty()) refusePlan(object.where(), "has no 'axes'");
  std::string combine = "product";
  object.read("combine", combine);
  if (combine != "product" && combine != "zip")
    refusePlan(object.where() + ": combine",
               "'" + clipped(combine) + "' is not right, it takes product or zip");
  plan.cells = combine == "zip" ? zipped(axes, object.where() + ": axes").steps
                                : product(axes, object.where());
  object.readList("skip", [&](const Json& value, const std::string& where) {
    const Condition skipped = conditionFrom(value, where);
    checkKnown(skipped, axes, where, "no axis");
    std::erase_if(plan.cells, [&](const SweepCell& cell) { return matches(cell, skipped); });
  });
  if (plan.cells.empty()) refusePlan(object.where(), "leaves no cell");
}

}  // namespace umbra

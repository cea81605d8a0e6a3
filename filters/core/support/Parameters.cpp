#include "filters/core/support/Parameters.h"

#include <charconv>
#include <cmath>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

[[noreturn]] void refuse(std::string_view where, const Parameter& parameter,
                         const std::string& found) {
  std::string right;
  if (!parameter.choices.empty()) {
    std::vector<std::string> names(parameter.choices.begin(), parameter.choices.end());
    right = "one of " + joined(names);
  } else {
    right = std::holds_alternative<int>(parameter.defaultValue)      ? "a whole number"
            : std::holds_alternative<double>(parameter.defaultValue) ? "a number"
                                                                     : "numbers, separated by ':',";
    right += " from " + shortNumber(parameter.low) + " to " + shortNumber(parameter.high);
  }
  throw Error(ErrorKind::BadInput,
              std::string(where) + ": " + found + " is not right, it takes " + right);
}

bool inRange(const Parameter& parameter, double value) {
  return std::isfinite(value) && value >= parameter.low && value <= parameter.high;
}

// A JSON file may write 2 for 2.0; nothing else is converted.
ParameterValue withKindOf(const ParameterValue& wanted, const ParameterValue& value) {
  if (std::holds_alternative<double>(wanted) && std::holds_alternative<int>(value))
    return double(std::get<int>(value));
  return value;
}

double numberFrom(std::string_view text, std::string_view where, const Parameter& parameter) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse(where, parameter, std::string("'").append(clipped(text)).append("'"));
  return value;
}

}  // namespace

void Parameter::set(const ParameterValue& given, std::string_view where) const {
  const ParameterValue value = withKindOf(defaultValue, given);
  if (value.index() != defaultValue.index()) refuse(where, *this, "'" + toText(given) + "'");
  bool fits = true;
  if (const auto* real = std::get_if<double>(&value)) fits = inRange(*this, *real);
  if (const auto* whole = std::get_if<int>(&value)) fits = inRange(*this, *whole);
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    for (double element : *list) fits = fits && inRange(*this, element);
  if (const auto* chosen = std::get_if<std::string>(&value)) {
    fits = false;
    for (std::string_view choice : choices) fits = fits || choice == *chosen;
  }
  if (!fits) refuse(where, *this, "'" + toText(given) + "'");
  put(value);
}

void Parameter::setFromText(std::string_view text, std::string_view where) const {
  if (std::holds_alternative<std::string>(defaultValue)) return set(std::string(text), where);
  if (std::holds_alternative<std::vector<double>>(defaultValue)) {
    std::vector<double> list;
    for (const std::string& part : split(text, ':')) list.push_back(numberFrom(part, where, *this));
    return set(list, where);
  }
  const double number = numberFrom(text, where, *this);
  if (std::holds_alternative<double>(defaultValue)) return set(number, where);
  if (number != std::floor(number) || std::abs(number) > 1e9)
    refuse(where, *this, "'" + std::string(text) + "'");
  set(int(number), where);
}

std::string ParameterView::text() const {
  return toText(get());
}

std::string toText(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, *real);
    return {buffer, result.ptr};
  }
  if (const auto* whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const auto* name = std::get_if<std::string>(&value)) return *name;
  std::vector<std::string> parts;
  for (double element : std::get<std::vector<double>>(value)) parts.push_back(toText(element));
  return joined(parts, ":");
}

namespace {

template <class Kind>
const Kind& findNamed(std::span<const Kind> parameters, std::string_view name,
                      std::string_view where) {
  std::vector<std::string> names;
  for (const Kind& parameter : parameters) {
    if (parameter.name == name) return parameter;
    names.emplace_back(parameter.name);
  }
  std::string message(where);
  message += ": there is no parameter '";
  message += clipped(name);
  message += "'";
  const std::string nearest = nearestWord(name, names);
  if (!nearest.empty())
    message += "; did you mean '" + nearest + "'?";
  else if (!names.empty())
    message += "; there are " + joined(names);
  else
    message += "; this technique has none";
  throw Error(ErrorKind::BadInput, message);
}

}  // namespace

const Parameter& parameterNamed(std::span<const Parameter> parameters, std::string_view name,
                                std::string_view where) {
  return findNamed(parameters, name, where);
}

const ParameterView& parameterNamed(std::span<const ParameterView> parameters,
                                    std::string_view name, std::string_view where) {
  return findNamed(parameters, name, where);
}

}  // namespace umbra

#include "filters/core/settings/Setting.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// Writes "1, 2, 4 or 8".
std::string alternatives(std::span<const int> values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i + 1 == values.size() ? " or " : ", ";
    text += std::to_string(values[i]);
  }
  return text;
}

// Writes "0 to 64", and whole numbers with all their digits.
std::string between(const SettingInfo& info) {
  const bool whole = info.kind == SettingKind::Whole || info.kind == SettingKind::Size;
  const auto text = [&](double value) {
    return whole ? std::to_string(long(value)) : shortNumber(value);
  };
  return text(info.low) + " to " + text(info.high);
}

bool inRange(const SettingInfo& info, double value) {
  return std::isfinite(value) && value >= info.low && value <= info.high;
}

bool isWhole(double value) {
  return value == std::floor(value) && std::abs(value) <= 1e9;
}

bool fits(const SettingInfo& info, bool) {
  return info.kind == SettingKind::Switch;
}

bool fits(const SettingInfo& info, int value) {
  if (info.kind != SettingKind::Whole) return false;
  if (info.values.empty()) return inRange(info, value);
  return std::find(info.values.begin(), info.values.end(), value) != info.values.end();
}

bool fits(const SettingInfo& info, double value) {
  const bool automatic = !info.automatic.empty() && value == 0.0;
  return info.kind == SettingKind::Number && (automatic || inRange(info, value));
}

bool fits(const SettingInfo& info, const std::string& value) {
  return info.kind == SettingKind::Choice &&
         std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
}

bool fits(const SettingInfo& info, const std::vector<double>& values) {
  const auto all = [&](auto right) { return std::all_of(values.begin(), values.end(), right); };
  switch (info.kind) {
    case SettingKind::Point:
      return values.size() == 3 && all([&](double value) { return inRange(info, value); });
    case SettingKind::Size:
      return values.size() == 2 &&
             all([&](double value) { return isWhole(value) && inRange(info, value); });
    case SettingKind::Camera:
      return values.empty() ||
             (values.size() == 10 && all([](double value) { return std::isfinite(value); }));
    default:
      return false;
  }
}

// A file may write 2 for 2.0; nothing else is converted.
SettingValue widened(const SettingInfo& info, const SettingValue& value) {
  const int* whole = std::get_if<int>(&value);
  return whole && info.kind == SettingKind::Number ? SettingValue(double(*whole)) : value;
}

std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<SettingValue> numbersIn(std::string_view text, std::string_view separators) {
  std::vector<double> values;
  for (std::size_t end = 0; end != text.npos;) {
    end = text.find_first_of(separators);
    const std::optional<double> value = numberIn(text.substr(0, end));
    if (!value) return std::nullopt;
    values.push_back(*value);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return values;
}

// Reads a value of the setting's kind, whether it is in range or not. Returns none if the text is
// of another kind.
std::optional<SettingValue> valueIn(const SettingInfo& info, std::string_view text) {
  switch (info.kind) {
    case SettingKind::Switch:
      if (text != "on" && text != "off") return std::nullopt;
      return text == "on";
    case SettingKind::Choice:
      return std::string(text);
    case SettingKind::Point:
      return numbersIn(text, ",");
    case SettingKind::Size:
      return numbersIn(text, "x");
    case SettingKind::Camera:
      return text == "none" ? SettingValue(std::vector<double>()) : numbersIn(text, ",:");
    case SettingKind::Whole:
    case SettingKind::Number:
      break;
  }
  const std::optional<double> number = numberIn(text);
  if (!number || info.kind == SettingKind::Number) return number;
  if (!isWhole(*number)) return std::nullopt;
  return int(*number);
}

}  // namespace

std::string_view nameOf(Stage stage) {
  constexpr std::string_view names[] = {"depth", "encode", "prefilter", "read", "shade", "nothing"};
  return names[std::size_t(stage)];
}

std::string rightValues(const SettingInfo& info) {
  switch (info.kind) {
    case SettingKind::Switch:
      return "on or off, in a file true or false";
    case SettingKind::Whole:
      return info.values.empty() ? "a whole number from " + between(info)
                                 : alternatives(info.values);
    case SettingKind::Number:
      if (info.automatic.empty()) return "a number from " + between(info);
      return "0 for " + std::string(info.automatic) + ", or a number from " + between(info);
    case SettingKind::Point:
      return "X,Y,Z, in a file [X, Y, Z], each a number from " + between(info);
    case SettingKind::Size:
      return "WIDTHxHEIGHT, in a file [WIDTH, HEIGHT], each a whole number from " + between(info);
    case SettingKind::Camera:
      return "none, or a camera";
    case SettingKind::Choice:
      break;
  }
  const std::vector<std::string> names(info.choices.begin(), info.choices.end());
  return "one of " + joined(names);
}

std::string rangeText(const SettingInfo& info) {
  if (info.kind == SettingKind::Switch || info.kind == SettingKind::Camera) return {};
  if (info.kind == SettingKind::Choice)
    return joined(std::vector<std::string>(info.choices.begin(), info.choices.end()));
  std::string text = info.values.empty() ? between(info) : alternatives(info.values);
  if (!info.unit.empty()) text += " " + std::string(info.unit);
  return text;
}

std::string defaultText(const SettingInfo& info, const SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  const bool automatic = number && *number == 0.0 && !info.automatic.empty();
  return toText(info, value) + (automatic ? ": " + std::string(info.automatic) : "");
}

std::string toText(const SettingInfo& info, const SettingValue& value) {
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "on" : "off";
  if (const int* whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const double* real = std::get_if<double>(&value)) return toText(ParameterValue(*real));
  if (const auto* name = std::get_if<std::string>(&value)) return *name;
  const auto& list = std::get<std::vector<double>>(value);
  if (list.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    // A camera is written as three points and an angle.
    if (i > 0) text += info.kind == SettingKind::Size ? "x" : i % 3 == 0 ? ":" : ",";
    text += toText(ParameterValue(list[i]));
  }
  return text;
}

void refuseSetting(const SettingInfo& info, std::string_view where, std::string_view found) {
  const std::string start = std::string(where) + ": " + std::string(found);
  if (info.kind != SettingKind::Choice)
    throw Error(ErrorKind::BadInput, start + " is not right, it takes " + rightValues(info));
  const std::vector<std::string> names(info.choices.begin(), info.choices.end());
  throw Error(ErrorKind::BadInput, start + " is none of " + joined(names));
}

SettingValue checked(const SettingInfo& info, const SettingValue& given, std::string_view where,
                     std::string_view found) {
  const SettingValue value = widened(info, given);
  if (!std::visit([&](const auto& held) { return fits(info, held); }, value))
    refuseSetting(info, where, found);
  return value;
}

SettingValue checkedText(const SettingInfo& info, std::string_view text, std::string_view where) {
  const std::string found = "'" + std::string(text) + "'";
  const std::optional<SettingValue> value = valueIn(info, text);
  if (!value) refuseSetting(info, where, found);
  return checked(info, *value, where, found);
}

void Setting::set(const SettingValue& value, std::string_view where) const {
  put(checked(info, value, where, "'" + toText(info, value) + "'"));
}

void Setting::setFromText(std::string_view text, std::string_view where) const {
  put(checkedText(info, text, where));
}

const Setting& settingNamed(std::span<const Setting> settings, std::string_view name,
                            std::string_view where) {
  std::vector<std::string> names;
  for (const Setting& setting : settings) {
    if (setting.info.name == name) return setting;
    names.emplace_back(setting.info.name);
  }
  const std::string nearest = nearestWord(name, names);
  throw Error(
      ErrorKind::BadInput,
      std::string(where) + ": there is no setting '" + std::string(name) + "'; " +
          (nearest.empty() ? "there are " + joined(names) : "did you mean '" + nearest + "'?"));
}

}  // namespace umbra

// A technique's parameters, declared once: a plain struct and one table of fields. The form in
// the window, the command-line option, the JSON key, the GLSL uniform, the documentation table
// and the range check are all derived from that table.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

namespace umbra {

// A real number, an integer, the name of a choice, or a list of reals.
using ParameterValue = std::variant<double, int, std::string, std::vector<double>>;

enum class Scale { Linear, Logarithmic };

// One row of a field table. T is double, int, an enum that counts up from 0 (then `choices` names
// its values in order) or std::vector<double> (the range then holds for every element).
template <class P, class T>
struct Field {
  T P::*member;
  std::string_view name;    // kebab-case, as on the command line
  std::string_view symbol;  // as in the paper: "σ²min"
  std::string_view unit;    // "" where there is none
  T low, high;              // inclusive
  std::string_view doc;     // one line
  Scale scale = Scale::Linear;
  std::span<const std::string_view> choices = {};
};

template <class P>
struct Field<P, std::vector<double>> {
  std::vector<double> P::*member;
  std::string_view name, symbol, unit;
  double low, high;
  std::string_view doc;
  Scale scale = Scale::Linear;
  std::span<const std::string_view> choices = {};
};

// A field without its types, to be read: what documents, labels and comparisons are made of.
struct ParameterView {
  std::string_view name, symbol, unit, doc;
  double low = 0.0, high = 1.0;
  Scale scale = Scale::Linear;
  std::span<const std::string_view> choices;
  ParameterValue defaultValue;
  std::function<ParameterValue()> get;

  std::string text() const;
};

// The same, to be set as well: what forms, options and files are made of.
struct Parameter : ParameterView {
  // Stores a value that `set` has checked.
  std::function<void(const ParameterValue&)> put;

  // Checks type and range, then stores. `where` names the origin for the error message: an
  // option, or a file and key. Throws BadInput.
  void set(const ParameterValue& value, std::string_view where) const;
  // The same for a text: "1e-6", "lloyd", "0.2:0.5:0.7".
  void setFromText(std::string_view text, std::string_view where) const;
};

std::string toText(const ParameterValue& value);

// The parameter of that name. Throws BadInput, with the nearest name as a suggestion.
const Parameter& parameterNamed(std::span<const Parameter> parameters, std::string_view name,
                                std::string_view where);
const ParameterView& parameterNamed(std::span<const ParameterView> parameters,
                                    std::string_view name, std::string_view where);

namespace detail {

template <class T>
ParameterValue toValue(const T& member, std::span<const std::string_view> choices) {
  if constexpr (std::is_enum_v<T>)
    return std::string(choices[std::size_t(member)]);
  else
    return member;
}

template <class T>
void fromValue(T& member, const ParameterValue& value, std::span<const std::string_view> choices) {
  if constexpr (std::is_enum_v<T>) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choices[i] == std::get<std::string>(value)) member = T(i);
  } else {
    member = std::get<T>(value);
  }
}

template <class P, class T>
ParameterView viewField(const P& values, const Field<P, T>& field) {
  ParameterView parameter{field.name, field.symbol, field.unit, field.doc};
  parameter.low = double(field.low);
  parameter.high = double(field.high);
  parameter.scale = field.scale;
  parameter.choices = field.choices;
  static const P defaults{};
  parameter.defaultValue = toValue(defaults.*field.member, field.choices);
  const T* member = &(values.*field.member);
  auto choices = field.choices;
  parameter.get = [member, choices] { return toValue(*member, choices); };
  return parameter;
}

template <class P, class T>
Parameter bindField(P& values, const Field<P, T>& field) {
  Parameter parameter{viewField<P>(values, field), {}};
  T* member = &(values.*field.member);
  auto choices = field.choices;
  parameter.put = [member, choices](const ParameterValue& v) { fromValue(*member, v, choices); };
  return parameter;
}

}  // namespace detail

// The fields of `values`, which must outlive the result, in the order of `fields` (a tuple of
// Field).
template <class P, class... T>
std::vector<Parameter> bindFields(P& values, const std::tuple<Field<P, T>...>& fields) {
  return std::apply(
      [&](const auto&... field) {
        return std::vector<Parameter>{detail::bindField(values, field)...};
      },
      fields);
}

// The same, to be read only.
template <class P, class... T>
std::vector<ParameterView> viewFields(const P& values, const std::tuple<Field<P, T>...>& fields) {
  return std::apply(
      [&](const auto&... field) {
        return std::vector<ParameterView>{detail::viewField<P>(values, field)...};
      },
      fields);
}

}  // namespace umbra

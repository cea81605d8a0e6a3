// Lets tests check JSON against a schema that uses the keywords of sessionSchema().
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace umbra {

namespace detail {

using SchemaJson = nlohmann::ordered_json;

inline bool hasType(const SchemaJson& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "number") return value.is_number();
  return type == "integer" && value.is_number_integer();
}

}  // namespace detail

// Says what is wrong first, and where; "" if all is right. A keyword that this function does not
// know counts as wrong, so that none stays unchecked.
inline std::string schemaFault(const nlohmann::ordered_json& schema,
                               const nlohmann::ordered_json& value, const std::string& where) {
  using detail::SchemaJson;
  const auto matches = [&](const SchemaJson& choices) {
    return std::count_if(choices.begin(), choices.end(), [&](const SchemaJson& choice) {
      return schemaFault(choice, value, where).empty();
    });
  };
  static const std::set<std::string> silent{"$schema", "title", "description", "default",
                                            "properties"};
  for (const auto& [keyword, right] : schema.items()) {
    const std::string fault = where + ": " + value.dump() + " against " + keyword;
    if (silent.contains(keyword)) continue;
    if (keyword == "type") {
      if (!detail::hasType(value, right)) return fault + " " + right.dump();
    } else if (keyword == "const") {
      if (value != right) return fault;
    } else if (keyword == "enum") {
      if (std::find(right.begin(), right.end(), value) == right.end()) return fault;
    } else if (keyword == "minimum") {
      if (!value.is_number() || value.get<double>() < right.get<double>()) return fault;
    } else if (keyword == "maximum") {
      if (!value.is_number() || value.get<double>() > right.get<double>()) return fault;
    } else if (keyword == "minItems") {
      if (value.size() < right.get<std::size_t>()) return fault;
    } else if (keyword == "maxItems") {
      if (value.size() > right.get<std::size_t>()) return fault;
    } else if (keyword == "items") {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string inner =
            schemaFault(right, value[i], where + "[" + std::to_string(i + 1) + "]");
        if (!inner.empty()) return inner;
      }
    } else if (keyword == "required") {
      for (const SchemaJson& key : right)
        if (!value.contains(key.get<std::string>())) return fault + " " + key.dump();
    } else if (keyword == "additionalProperties") {
      const SchemaJson known = schema.value("properties", SchemaJson::object());
      for (const auto& [key, member] : value.items()) {
        const bool named = known.contains(key);
        if (!named && right == false) return where + "." + key + ": is not allowed";
        const std::string inner =
            schemaFault(named ? known[key] : right, member, where + "." + key);
        if (!inner.empty()) return inner;
      }
    } else if (keyword == "anyOf") {
      if (matches(right) == 0) return fault;
    } else if (keyword == "oneOf") {
      if (matches(right) != 1) return fault;
    } else {
      return keyword + ": is no keyword that is checked";
    }
  }
  return {};
}

}  // namespace umbra

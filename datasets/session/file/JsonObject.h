// Strict reading of JSON objects: a missing type, an unknown key or a value out of range is an
// error that names the file and the key.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

class JsonObject {
 public:
  // `where` is what errors begin with: "session.json" or "session.json: frame.kernel". Throws
  // BadInput when `value` is no object.
  JsonObject(const nlohmann::ordered_json& value, std::string where);

  // Each leaves `target` alone where the key is absent.
  void read(std::string_view key, double& target, double low, double high);
  void read(std::string_view key, int& target, int low, int high);
  void read(std::string_view key, bool& target);
  void read(std::string_view key, std::string& target);
  // A name that `parse` turns into a value; whatever Error it throws becomes BadInput. `where`
  // names file and key, for the error's message.
  void readName(
      std::string_view key,
      const std::function<void(const std::string& name, const std::string& where)>& parse);
  // Calls `visit` with the value at `key`, whatever it is, and with file and key.
  void readValue(std::string_view key, const std::function<void(const nlohmann::ordered_json& value,
                                                                const std::string& where)>& visit);
  // Exactly three finite numbers.
  void readVector(std::string_view key, double (&target)[3]);
  // Calls `visit` with the object at `key`.
  void readObject(std::string_view key, const std::function<void(JsonObject&)>& visit);
  // Calls `visit` with every element of the list at `key`, and file and key with its place from 1:
  // "steps[2]".
  void readList(std::string_view key,
                const std::function<void(const nlohmann::ordered_json& element,
                                         const std::string& where)>& visit);
  // Takes a text, or a list of texts that are its lines.
  void readLines(std::string_view key, std::string& target);
  // Calls `visit` with every key that no read asked for and its value.
  void readRest(const std::function<void(const std::string& key, const nlohmann::ordered_json&,
                                         const std::string& where)>& visit);

  // Throws BadInput for a key that nothing above asked for, with the nearest one that is known.
  void finish() const;

  const std::string& where() const { return where_; }

 private:
  const nlohmann::ordered_json* find(std::string_view key);
  std::string whereOf(std::string_view key) const;
  [[noreturn]] void refuse(std::string_view key, const std::string& right) const;

  const nlohmann::ordered_json& value_;
  std::string where_;
  std::vector<std::string> known_;
};

}  // namespace umbra

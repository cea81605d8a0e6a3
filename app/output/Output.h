// Where results go: standard output, or a folder that gets all its files or none.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

// Keeps the order in which fields are written, so that files read as they are documented.
using Json = nlohmann::ordered_json;

// To standard output, complete. Throws BadOutput when it is closed or full.
void print(std::string_view text);
// One JSON object and nothing else.
void printJson(const Json& object);
std::string toText(const Json& object);

// Collects the files of a result in a hidden folder inside `folder`; `finish` puts them in place
// and names each on standard error. What is not finished leaves nothing behind.
class OutputFolder {
 public:
  // Makes the folder where needed. Throws BadOutput that names it when it cannot be written.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // The staging path to write `name` to; finish() moves it into the folder. Throws BadOutput for a
  // name that would lie elsewhere.
  std::filesystem::path file(const std::string& name);
  // Throws BadOutput where a file cannot take its place; then none has, and what was there stays.
  void finish();

 private:
  std::filesystem::path folder_, staging_;
  bool made_ = false;  // the folder did not exist before
  bool finished_ = false;
  std::vector<std::string> names_;
};

// Throws BadOutput now rather than after the work when `file` could not be written: its folder
// cannot be made or written, or it is a folder itself.
void checkWritable(const std::filesystem::path& file);
// Names a written file on standard error.
void announce(const std::filesystem::path& file);

}  // namespace umbra

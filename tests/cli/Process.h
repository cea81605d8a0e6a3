// Runs the program as a shell would, without a display.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace umbra::cli {

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;

struct Outcome {
  int status = -1;  // exit status; 128 + n where signal n ended the process
  std::string out, err;

  // The one JSON object on standard output. Fails the test where there is anything else.
  Json json() const;
};

struct Setting {
  std::map<std::string, std::string> environment;  // added to the caller's, which has no display
  std::string output;                              // a file for standard output; "" captures it
  bool interrupt = false;                          // send SIGINT as soon as the program catches it
};

Outcome run(const Arguments& arguments, const Setting& setting = {});

// A temporary folder that is removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  // Names of everything inside, hidden files as well, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string contentOf(const std::filesystem::path& file);

}  // namespace umbra::cli

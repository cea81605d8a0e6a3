#include "app/output/Output.h"

#include <unistd.h>

#include <iostream>
#include <system_error>

#include "filters/core/support/Error.h"

namespace umbra {

namespace fs = std::filesystem;

void print(std::string_view text) {
  std::cout.write(text.data(), std::streamsize(text.size()));
  std::cout.flush();
  if (!std::cout) throw Error(ErrorKind::BadOutput, "standard output: cannot be written");
}

std::string toText(const Json& object) {
  // File names need not be UTF-8, JSON must be.
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void printJson(const Json& object) {
  print(toText(object));
}

OutputFolder::OutputFolder(const fs::path& folder)
    : folder_(folder), staging_(folder / (".umbrascope-" + std::to_string(getpid()))) {
  std::error_code problem;
  made_ = !fs::exists(folder_, problem);
  fs::create_directories(folder_, problem);
  if (!problem) fs::create_directory(staging_, problem);
  if (problem || !fs::is_directory(staging_))
    throw Error(ErrorKind::BadOutput, folder_.string() + ": cannot be written: " +
                                          (problem ? problem.message() : "it is not a folder"));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  // Only succeeds where the folder is empty.
  if (made_ && !finished_) fs::remove(folder_, ignored);
}

fs::path OutputFolder::file(const std::string& name) {
  names_.push_back(name);
  return staging_ / name;
}

void OutputFolder::finish() {
  for (const std::string& name : names_) {
    std::error_code problem;
    fs::rename(staging_ / name, folder_ / name, problem);
    if (problem)
      throw Error(ErrorKind::BadOutput,
                  (folder_ / name).string() + ": cannot be written: " + problem.message());
  }
  finished_ = true;
  for (const std::string& name : names_) announce(folder_ / name);
}

void checkWritable(const fs::path& file) {
  if (fs::is_directory(file))
    throw Error(ErrorKind::BadOutput, file.string() + ": is a folder, not a file");
  // The nearest folder above the file that exists must take new entries.
  fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  while (!fs::exists(folder))
    folder = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (!fs::is_directory(folder) || access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(ErrorKind::BadOutput,
                file.string() + ": " + folder.string() + " is not a folder that can be written");
}

void announce(const fs::path& file) {
  std::cerr << file.string() << '\n';
}

}  // namespace umbra

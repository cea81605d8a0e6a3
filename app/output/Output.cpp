#include "app/output/Output.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "filters/core/support/AtomicFile.h"
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

OutputFolder::OutputFolder(const fs::path& folder) : folder_(folder) {
  std::error_code problem;
  made_ = !fs::exists(folder_, problem);
  fs::create_directories(folder_, problem);
  if (problem || !fs::is_directory(folder_, problem))
    throw Error(ErrorKind::BadOutput, folder_.string() + ": cannot be written: " +
                                          (problem ? problem.message() : "it is not a folder"));
  removeLeftOvers(folder_);
  staging_ = makeStagingFolder(folder_);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  // Only succeeds where the folder is empty.
  if (made_ && !finished_) fs::remove(folder_, ignored);
}

fs::path OutputFolder::file(const std::string& name) {
  if (!isPlainName(name))
    throw Error(ErrorKind::BadOutput, "'" + name + "' is no name of a file in " + folder_.string());
  names_.push_back(name);
  return staging_ / name;
}

// All files take their places or none does: those that they replace wait until the last one has.
void OutputFolder::finish() {
  const fs::path replaced = makeStagingFolder(staging_);
  std::vector<std::string> moved;
  const auto place = [&](const std::string& name) {
    moved.push_back(name);
    std::error_code none;
    fs::rename(folder_ / name, replaced / name, none);  // there may be nothing to replace
    fs::rename(staging_ / name, folder_ / name);
  };
  const auto undo = [&](const std::string& name) {
    std::error_code none;
    fs::rename(folder_ / name, staging_ / name, none);
    fs::rename(replaced / name, folder_ / name, none);
  };
  for (const std::string& name : names_) {
    try {
      if (fs::is_directory(folder_ / name)) throw std::runtime_error("is a folder, not a file");
      place(name);
    } catch (const std::exception& error) {
      const auto* system = dynamic_cast<const fs::filesystem_error*>(&error);
      const std::string why = system ? system->code().message() : std::string(error.what());
      std::for_each(moved.rbegin(), moved.rend(), undo);
      throw Error(ErrorKind::BadOutput, (folder_ / name).string() + ": cannot be written: " + why);
    }
  }
  finished_ = true;
  for (const std::string& name : names_) announce(folder_ / name);
}

void checkWritable(const fs::path& file) {
  std::error_code problem;
  if (fs::is_directory(file, problem))
    throw Error(ErrorKind::BadOutput, file.string() + ": is a folder, not a file");
  // The nearest folder above the file that exists must take new entries.
  fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  while (!fs::exists(folder, problem))
    folder = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, problem) || access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(ErrorKind::BadOutput,
                file.string() + ": " + folder.string() + " is not a folder that can be written");
}

void announce(const fs::path& file) {
  std::cerr << file.string() << '\n';
}

}  // namespace umbra

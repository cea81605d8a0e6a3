#include "filters/core/support/AtomicFile.h"

#include <unistd.h>

#include <fstream>
#include <string>
#include <system_error>

#include "filters/core/support/Error.h"

namespace umbra {

namespace fs = std::filesystem;

void writeAtomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder))
    throw Error(ErrorKind::BadOutput, file.string() + ": its folder cannot be made");
  if (fs::is_directory(file))
    throw Error(ErrorKind::BadOutput, file.string() + ": is a folder, not a file");
  const fs::path temporary = folder / ("." + file.stem().string() + "." + std::to_string(getpid()) +
                                       file.extension().string());
  try {
    write(temporary);
    fs::rename(temporary, file);
  } catch (const std::exception& error) {
    fs::remove(temporary, problem);
    throw Error(ErrorKind::BadOutput, file.string() + ": cannot be written: " + error.what());
  }
}

void writeTextAtomically(const fs::path& file, std::string_view text) {
  writeAtomically(file, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream) throw std::runtime_error(std::generic_category().message(errno));
  });
}

}  // namespace umbra

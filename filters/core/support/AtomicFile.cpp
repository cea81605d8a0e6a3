#include "filters/core/support/AtomicFile.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <optional>
#include <system_error>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// A temporary folder is called ".umbrascope-HOST-PROCESS-XXXXXX"; six random characters take the
// place of the X.
constexpr std::string_view mark = ".umbrascope-";

// Which machine it is, so that nobody takes away what another one writes into a shared folder.
std::string hostMark() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return std::to_string(std::hash<std::string_view>{}(name) % 1000000);
}

std::string temporaryTemplate() {
  return std::string(mark) + hostMark() + "-" + std::to_string(getpid()) + "-XXXXXX";
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(ErrorKind::BadOutput, file.string() + ": " + why);
}

[[noreturn]] void throwSystemError() {
  throw std::runtime_error(std::generic_category().message(errno));
}

// Where the bytes go: behind a symbolic link, the place that it points to.
fs::path targetOf(const fs::path& file) {
  fs::path target = file;
  for (int links = 0; links < 40; ++links) {
    std::error_code problem;
    if (!fs::is_symlink(fs::symlink_status(target, problem))) return target;
    const fs::path next = fs::read_symlink(target, problem);
    if (problem) refuse(file, "is a link that cannot be followed: " + problem.message());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  refuse(file, "is a link that leads in a circle");
}

// A folder of its own for one file, which nobody else can enter; removed with what is left in it.
class TemporaryPlace {
 public:
  TemporaryPlace(const fs::path& folder, const std::string& extension)
      : folder_(makeStagingFolder(folder)), path_(folder_ / ("file" + extension)) {}
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;
  ~TemporaryPlace() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  const fs::path& path() const { return path_; }

  // It is on the disk before it takes the other's place, so that no crash leaves neither, and it
  // has the permissions of what stood there.
  void renameTo(const fs::path& target) const {
    const int descriptor = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throwSystemError();
    struct stat old {};
    const bool kept = stat(target.c_str(), &old) != 0 ||
                      fchmod(descriptor, old.st_mode & 07777) == 0 || errno == EPERM;
    const bool flushed = fsync(descriptor) == 0 || errno == EINVAL;
    const int problem = errno;
    close(descriptor);
    errno = problem;
    if (!kept || !flushed || rename(path_.c_str(), target.c_str()) != 0) throwSystemError();
  }

 private:
  fs::path folder_, path_;
};

// The process that a temporary name belongs to, where it is one of this machine.
std::optional<pid_t> processOf(const std::string& name) {
  const std::string prefix = std::string(mark) + hostMark() + "-";
  if (!name.starts_with(prefix)) return std::nullopt;
  pid_t process = 0;
  const char *from = name.data() + prefix.size(), *end = name.data() + name.size();
  const auto [after, problem] = std::from_chars(from, end, process);
  if (problem != std::errc() || after == end || *after != '-' || process <= 0) return std::nullopt;
  return process;
}

}  // namespace

void writeAtomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const fs::path target = targetOf(file);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder, problem)) refuse(file, "its folder cannot be made");
  if (fs::is_directory(target, problem)) refuse(file, "is a folder, not a file");
  removeLeftOvers(folder);
  try {
    const TemporaryPlace temporary(folder, target.extension().string());
    write(temporary.path());
    temporary.renameTo(target);
  } catch (const std::exception& error) {
    refuse(file, std::string("cannot be written: ") + error.what());
  }
}

void writeTextAtomically(const fs::path& file, std::string_view text) {
  writeAtomically(file, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream) throwSystemError();
  });
}

fs::path makeStagingFolder(const fs::path& folder) {
  std::string path = (folder / temporaryTemplate()).string();
  if (!mkdtemp(path.data()))
    refuse(folder, "cannot be written: " + std::generic_category().message(errno));
  return path;
}

void removeLeftOvers(const fs::path& folder) {
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::optional<pid_t> process = processOf(entry->path().filename().string());
    if (!process || kill(*process, 0) == 0 || errno != ESRCH) continue;
    std::error_code ignored;
    fs::remove_all(entry->path(), ignored);
  }
}

bool isPlainName(std::string_view name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string_view::npos &&
         name.find('\0') == std::string_view::npos;
}

}  // namespace umbra

#include "filters/core/support/InputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

[[noreturn]] void refuseInput(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file.string() + ": " + what);
}

[[noreturn]] void refuseAsTheSystemDoes(const std::filesystem::path& file) {
  if (errno == ENOENT || errno == ENOTDIR) refuseInput(file, "there is no such file");
  refuseInput(file, "cannot be read: " + std::generic_category().message(errno));
}

// Open for reading, a regular file of a size that is known.
class OpenFile {
 public:
  OpenFile(const std::filesystem::path& file, std::uintmax_t most) : file_(file) {
    // Without O_NONBLOCK a pipe would wait for somebody to write into it.
    descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor_ < 0) refuseAsTheSystemDoes(file);
    try {
      check(most);
    } catch (...) {
      close(descriptor_);
      throw;
    }
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { close(descriptor_); }

  std::uintmax_t size() const { return size_; }

  std::string content() const {
    std::string content(std::size_t(size_), '\0');
    std::size_t done = 0;
    while (done < content.size()) {
      const ssize_t count = read(descriptor_, content.data() + done, content.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) refuseAsTheSystemDoes(file_);
      if (count == 0) break;  // somebody cut it short meanwhile
      done += std::size_t(count);
    }
    content.resize(done);
    return content;
  }

 private:
  void check(std::uintmax_t most) {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) refuseAsTheSystemDoes(file_);
    if (S_ISDIR(status.st_mode)) refuseInput(file_, "is a folder, not a file");
    if (!S_ISREG(status.st_mode)) refuseInput(file_, "is a pipe or a device, not a file");
    size_ = std::uintmax_t(status.st_size);
    if (size_ > most)
      refuseInput(file_, "has " + std::to_string(size_) + " bytes, at most " +
                             std::to_string(most) + " are read");
  }

  const std::filesystem::path& file_;
  int descriptor_ = -1;
  std::uintmax_t size_ = 0;
};

}  // namespace

std::uintmax_t checkInput(const std::filesystem::path& file, std::uintmax_t most) {
  return OpenFile(file, most).size();
}

std::string contentOf(const std::filesystem::path& file, std::uintmax_t most) {
  return OpenFile(file, most).content();
}

}  // namespace umbra

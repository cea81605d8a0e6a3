#include "datasets/scenes/ArchiveFile.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestEntry = std::size_t(256) << 20;

struct Free {
  void operator()(archive* a) const { archive_read_free(a); }
};

[[noreturn]] void refuseArchive(const fs::path& file, const std::string& what) {
  std::string line = file.string() + ": " + what;
  std::replace(line.begin(), line.end(), '\n', ' ');
  throw Error(ErrorKind::BadInput, line);
}

std::string textOf(archive* reader) {
  const char* text = archive_error_string(reader);
  return text ? text : "unknown trouble";
}

// Reads the current entry. Its stated size is not trusted: the entry is read until it ends.
std::string contentOf(archive* reader, const fs::path& file, const std::string& name) {
  std::string content;
  char block[1 << 16];
  for (;;) {
    const la_ssize_t count = archive_read_data(reader, block, sizeof block);
    if (count < 0) refuseArchive(file, "'" + name + "' in it is damaged: " + textOf(reader));
    if (count == 0) return content;
    content.append(block, std::size_t(count));
    if (content.size() > largestEntry)
      refuseArchive(file, "'" + name + "' in it is larger than 256 MB");
  }
}

}  // namespace

std::vector<std::string> readArchive(const fs::path& file,
                                     const std::vector<std::string>& entries) {
  const std::unique_ptr<archive, Free> reader(archive_read_new());
  archive_read_support_format_zip(reader.get());
  if (archive_read_open_filename(reader.get(), file.c_str(), 1 << 16) != ARCHIVE_OK)
    refuseArchive(file, "cannot be read as a ZIP archive: " + textOf(reader.get()));
  std::vector<std::string> contents(entries.size());
  std::vector<bool> found(entries.size(), false);
  archive_entry* entry = nullptr;
  for (int status = 0; (status = archive_read_next_header(reader.get(), &entry)) != ARCHIVE_EOF;) {
    if (status < ARCHIVE_WARN) refuseArchive(file, "is damaged: " + textOf(reader.get()));
    const char* path = archive_entry_pathname(entry);
    const auto wanted = std::find(entries.begin(), entries.end(), path ? path : "");
    if (wanted == entries.end()) continue;
    const auto i = std::size_t(wanted - entries.begin());
    contents[i] = contentOf(reader.get(), file, entries[i]);
    found[i] = true;
    if (std::find(found.begin(), found.end(), false) == found.end()) return contents;
  }
  const auto i = std::size_t(std::find(found.begin(), found.end(), false) - found.begin());
  refuseArchive(file, "has no entry '" + entries[i] + "'");
}

}  // namespace umbra

// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace umbra {

// Calls `write` with a temporary path below the folder of `file` (same extension), then renames the
// result to `file`. Creates the folder where needed. If `write` throws or the rename fails, the
// temporary file is removed, what stood at `file` stays, and BadOutput names `file`.
//
// The temporary file lies in a hidden folder with a name that nobody can guess and that nobody else
// can enter, so that no link can be planted there. What is at `file` keeps its permissions; where
// it is a symbolic link, the file that it points to is replaced, not the link.
void writeAtomically(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path&)>& write);

void writeTextAtomically(const std::filesystem::path& file, std::string_view text);

// Makes a new, empty folder inside `folder` for what is not finished, hidden and with a name that
// nobody can guess. Throws BadOutput that names `folder`.
std::filesystem::path makeStagingFolder(const std::filesystem::path& folder);

// Removes from `folder` the temporary files and folders of processes of this machine that have
// ended without doing so: one was killed.
void removeLeftOvers(const std::filesystem::path& folder);

// Whether `name` is the name of a file in a folder, and of none elsewhere: not "", "..", "a/b".
bool isPlainName(std::string_view name);

}  // namespace umbra

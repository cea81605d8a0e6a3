// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace umbra {

// Calls `write` with a temporary path in the folder of `file` (same extension), then renames the
// result to `file`. Creates the folder where needed. If `write` throws or the rename fails, the
// temporary file is removed, what stood at `file` stays, and BadOutput names `file`.
void writeAtomically(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path&)>& write);

void writeTextAtomically(const std::filesystem::path& file, std::string_view text);

}  // namespace umbra

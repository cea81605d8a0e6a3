// Lines and words of mesh files that are text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace umbra::meshfile {

// Removes the next line from `rest` and returns it without its end; nothing where there is none.
std::optional<std::string_view> nextLine(std::string_view& rest);

// Removes the next word from `rest`; empty where there is none.
std::string_view nextWord(std::string_view& rest);

// A word as a number; nothing where it is not one. A number that is too large is infinite.
std::optional<float> realFrom(std::string_view word);
std::optional<std::int64_t> wholeFrom(std::string_view word);

// Removes three words from `rest` and appends them to `out` as " x y z", or as " 0 0 0" where one
// is not finite; returns whether all are finite. Nothing where a word is missing or is not a
// number.
std::optional<bool> copyVector(std::string_view& rest, std::string& out);

[[noreturn]] void refuse(const std::string& file, const std::string& what);
[[noreturn]] void refuseLine(const std::string& file, std::size_t line, const std::string& what);

}  // namespace umbra::meshfile

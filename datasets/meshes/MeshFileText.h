// Lines and words of mesh files that are text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace umbra::meshfile {

// Takes the next line off `rest`, without its end; nothing where there is none.
std::optional<std::string_view> nextLine(std::string_view& rest);

// Takes the next word off `rest`; empty where there is none.
std::string_view nextWord(std::string_view& rest);

// A word as a number; nothing where it is none. Too large a one is infinite.
std::optional<float> realFrom(std::string_view word);
std::optional<std::int64_t> wholeFrom(std::string_view word);

// Takes three words off `rest` and appends them to `out` as " x y z", or " 0 0 0" where one is
// not finite; returns whether all are. Nothing where a word is missing or no number.
std::optional<bool> copyVector(std::string_view& rest, std::string& out);

[[noreturn]] void refuse(const std::string& file, const std::string& what);
[[noreturn]] void refuseLine(const std::string& file, std::size_t line, const std::string& what);

}  // namespace umbra::meshfile

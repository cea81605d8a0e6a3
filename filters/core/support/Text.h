// Numbers and lists as people read them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

// Four significant digits, no trailing zeros: 0.2264, 1e-06, 12.
std::string shortNumber(double value);

// "a, b, c"
std::string joined(std::span<const std::string> parts, std::string_view separator = ", ");

// "a:b:c" split at `separator`; an empty text gives no parts.
std::vector<std::string> split(std::string_view text, char separator);

// The candidate nearest to a mistyped `word`, or "" when none is near. A word of three characters
// or more that a candidate begins with was broken off: then the shortest such candidate.
std::string nearestWord(std::string_view word, std::span<const std::string> candidates);

// Text of an input as a message quotes it: its first 80 bytes and "…", where it is longer. What is
// no character to be shown stands as "\x1b".
std::string clipped(std::string_view text);

// The lines of a text as one, without control characters, and spaces at its end.
std::string oneLine(std::string text);

}  // namespace umbra

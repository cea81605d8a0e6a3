#include "filters/core/support/Text.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace umbra {
namespace {

// Bytes of the character of UTF-8 that the text begins with; 0 where it begins with none that a
// terminal may show: a byte that is no part of UTF-8, or a control character, such as the one that
// begins a terminal's commands.
std::size_t shownBytes(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t bytes = first >= 0xc2 && first < 0xe0   ? 2
                            : first >= 0xe0 && first < 0xf0 ? 3
                            : first >= 0xf0 && first < 0xf5 ? 4
                                                            : 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool isControl = first == 0xc2 && byte(1) < 0xa0;
  const bool isTooLong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool isHalfOfAPair = first == 0xed && byte(1) >= 0xa0;
  return isControl || isTooLong || isHalfOfAPair ? 0 : bytes;
}

// "\x1b"
std::string escaped(char byte) {
  char buffer[8];
  std::snprintf(buffer, sizeof buffer, "\\x%02x", static_cast<unsigned>(byte) & 0xff);
  return buffer;
}

}  // namespace

std::string shortNumber(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

std::string joined(std::span<const std::string> parts, std::string_view separator) {
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty()) text += separator;
    text += part;
  }
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  // A separator at the end has an empty part behind it, as one at the beginning has before it.
  for (std::size_t end = text.find(separator); end != text.npos; end = text.find(separator)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.emplace_back(text);
  return parts;
}

namespace {

// Levenshtein distance, one row at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearestWord(std::string_view word, std::span<const std::string> candidates) {
  std::string nearest;
  if (word.size() >= 3)
    for (const std::string& candidate : candidates)
      if (candidate.starts_with(word) && (nearest.empty() || candidate.size() < nearest.size()))
        nearest = candidate;
  if (!nearest.empty()) return nearest;
  std::size_t best = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string clipped(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string out;
  while (!text.empty()) {
    const std::size_t bytes = shownBytes(text);
    const std::string shown = bytes > 0 ? std::string(text.substr(0, bytes)) : escaped(text[0]);
    if (out.size() + shown.size() > longest) return out + "…";
    out += shown;
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return out;
}

std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace umbra

#include "datasets/meshes/MeshFileText.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "filters/core/support/Error.h"

namespace umbra::meshfile {

std::optional<std::string_view> nextLine(std::string_view& rest) {
  if (rest.empty()) return std::nullopt;
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view nextWord(std::string_view& rest) {
  constexpr std::string_view blank = " \t\r\n\v\f";
  const std::size_t start = rest.find_first_not_of(blank);
  if (start == std::string_view::npos) {
    rest = {};
    return {};
  }
  rest.remove_prefix(start);
  const std::string_view word = rest.substr(0, rest.find_first_of(blank));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<float> realFrom(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  // The number is read as a double: from_chars takes a float that underflows for an error, and
  // everybody else for 0.
  double value = 0.0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || problem == std::errc::invalid_argument)
    return std::nullopt;
  if (problem == std::errc::result_out_of_range)
    return word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos
               ? std::numeric_limits<float>::infinity()
               : 0.0f;
  return float(value);
}

std::optional<std::int64_t> wholeFrom(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<bool> copyVector(std::string_view& rest, std::string& out) {
  const std::size_t start = out.size();
  bool finite = true;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = nextWord(rest);
    const std::optional<float> value = realFrom(word);
    if (!value) return std::nullopt;
    finite = finite && std::isfinite(*value);
    // A word that underflows would stop the reader's stream as well.
    (out += ' ') += *value == 0.0f ? std::string_view("0") : word;
  }
  if (!finite) out.replace(start, std::string::npos, " 0 0 0");
  return finite;
}

void refuse(const std::string& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file + ": " + what);
}

void refuseLine(const std::string& file, std::size_t line, const std::string& what) {
  refuse(file, "line " + std::to_string(line) + " " + what);
}

}  // namespace umbra::meshfile

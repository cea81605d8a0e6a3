#include "datasets/meshes/MeshFileText.h"

#include <charconv>
#include <limits>

#include "filters/core/support/Error.h"

namespace umbra::meshfile {
namespace {

// Lines are told of so often.
constexpr std::size_t linesBetween = 8192;

void appendUtf8(std::string& out, std::uint32_t point) {
  const auto tail = [&](int shift) { out += char(0x80 | (point >> shift & 0x3f)); };
  if (point < 0x80) {
    out += char(point);
  } else if (point < 0x800) {
    out += char(0xc0 | point >> 6);
    tail(0);
  } else if (point < 0x10000) {
    out += char(0xe0 | point >> 12);
    tail(6), tail(0);
  } else {
    out += char(0xf0 | point >> 18);
    tail(12), tail(6), tail(0);
  }
}

// UTF-16 after its byte-order mark. A surrogate without its other half becomes U+FFFD.
std::string utf8From16(std::string_view bytes, bool bigEnd) {
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]),
               b = static_cast<unsigned char>(bytes[i + 1]);
    return std::uint32_t(bigEnd ? a << 8 | b : b << 8 | a);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t point = unit(i);
    if (point >= 0xd800 && point < 0xe000) {
      const std::uint32_t low = point < 0xdc00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
      const bool paired = low >= 0xdc00 && low < 0xe000;
      point = paired ? 0x10000 + ((point - 0xd800) << 10) + (low - 0xdc00) : 0xfffd;
      if (paired) i += 2;
    }
    appendUtf8(text, point);
  }
  return text;
}

bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool endsInBackslash(std::string_view line) {
  const std::string_view text = trimmed(line);
  return !text.empty() && text.back() == '\\';
}

// Whether a backslash at the line's end joins it with the next. Comments and names may end so by
// chance, as paths of Windows do.
bool mayJoin(std::string_view line) {
  if (line.find('#') != std::string_view::npos) return false;
  const std::string_view key = nextWord(line);
  return key != "mtllib" && key != "usemtl" && key != "o" && key != "g";
}

}  // namespace

std::string_view plainText(std::string_view content, std::string& converted) {
  if (content.starts_with("\xef\xbb\xbf")) return content.substr(3);
  const bool bigEnd = content.starts_with("\xfe\xff");
  if (!bigEnd && !content.starts_with("\xff\xfe")) return content;
  converted = utf8From16(content.substr(2), bigEnd);
  return converted;
}

std::optional<std::string_view> TextLines::nextPhysical() {
  if (rest_.empty()) return std::nullopt;
  if (++read_ % linesBetween == 0) progress_.tell(1.0 - double(rest_.size()) / double(bytes_));
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(line.size());
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
  return line;
}

std::optional<std::string_view> TextLines::next() {
  std::optional<std::string_view> line = nextPhysical();
  number_ = read_;
  if (!line || backslash_ == Backslash::IsText || !endsInBackslash(*line) || !mayJoin(*line))
    return line;
  joined_.clear();
  for (; line && endsInBackslash(*line); line = nextPhysical())
    (joined_ += line->substr(0, line->rfind('\\'))) += ' ';
  if (line) joined_ += *line;
  return joined_;
}

std::optional<std::string_view> TextLines::nextWithWords() {
  while (auto line = next()) {
    *line = line->substr(0, line->find('#'));
    if (!trimmed(*line).empty()) return line;
  }
  return std::nullopt;
}

std::string_view nextWord(std::string_view& rest) {
  std::size_t start = 0;
  while (start < rest.size() && isBlank(rest[start])) ++start;
  std::size_t end = start;
  while (end < rest.size() && !isBlank(rest[end])) ++end;
  const std::string_view word = rest.substr(start, end - start);
  rest.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view rest) {
  while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
  return rest;
}

std::string lowered(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

std::optional<double> realFrom(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::string_view left(end, std::size_t(word.data() + word.size() - end));
  if (problem == std::errc::invalid_argument) return std::nullopt;
  if (left.starts_with("#IND") || left.starts_with("#QNAN") || left.starts_with("#SNAN") ||
      left.starts_with("#INF"))
    return std::numeric_limits<double>::quiet_NaN();
  if (!left.empty()) return std::nullopt;
  if (problem == std::errc::result_out_of_range)
    return word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos
               ? std::numeric_limits<double>::infinity()
               : 0.0;
  return value;
}

std::optional<std::int64_t> wholeFrom(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<Eigen::Vector3d> vectorFrom(std::string_view& rest) {
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value = realFrom(nextWord(rest));
    if (!value) return std::nullopt;
    vector[i] = *value;
  }
  return vector;
}

void refuse(const std::string& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file + ": " + what);
}

void refuseLine(const std::string& file, std::size_t line, const std::string& what) {
  refuse(file, "line " + std::to_string(line) + " " + what);
}

}  // namespace umbra::meshfile

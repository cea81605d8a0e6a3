// Lines, words and numbers of mesh files that are text.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "filters/core/support/Progress.h"

namespace umbra::meshfile {

// The text without a byte-order mark. UTF-16 becomes UTF-8 and then lies in `converted`, which the
// result refers to.
std::string_view plainText(std::string_view content, std::string& converted);

// The lines of a text, whichever way they end: LF, CRLF or CR alone.
class TextLines {
 public:
  // In an OBJ file a backslash at a line's end joins it with the next one.
  enum class Backslash { IsText, Joins };

  explicit TextLines(std::string_view text, Backslash backslash = Backslash::IsText,
                     const Progress& progress = {})
      : rest_(text), backslash_(backslash), bytes_(text.size()), progress_(progress) {}

  // The next line without its end; nothing where there is none. It is valid until the next call.
  std::optional<std::string_view> next();
  // The next line that has a word, without what follows a '#'.
  std::optional<std::string_view> nextWithWords();
  // The number of the line that was given last, from 1; of joined ones the first.
  std::size_t number() const { return number_; }
  // What follows the line that was given last.
  std::string_view rest() const { return rest_; }

 private:
  std::optional<std::string_view> nextPhysical();

  std::string_view rest_;
  std::string joined_;
  Backslash backslash_;
  std::size_t read_ = 0, number_ = 0, bytes_ = 0;
  Progress progress_;
};

// Removes the next word from `rest`; empty where there is none.
std::string_view nextWord(std::string_view& rest);
// `rest` without the blanks at its ends: a name that may hold blanks.
std::string_view trimmed(std::string_view rest);
// ASCII letters as small ones.
std::string lowered(std::string_view word);

// A word as a number; nothing where it is not one. A number that is too large is infinite, and what
// Microsoft's library writes for a value that is none, such as "-1.#IND", is NaN.
std::optional<double> realFrom(std::string_view word);
std::optional<std::int64_t> wholeFrom(std::string_view word);

// Removes three words from `rest`; nothing where a word is missing or is not a number. The values
// need not be finite.
std::optional<Eigen::Vector3d> vectorFrom(std::string_view& rest);

[[noreturn]] void refuse(const std::string& file, const std::string& what);
[[noreturn]] void refuseLine(const std::string& file, std::size_t line, const std::string& what);

}  // namespace umbra::meshfile

#include "datasets/lessons/LessonNumbers.h"

#include <array>
#include <cstdio>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

// "{{variance}}", or a difference of two quantities.
struct Number {
  LessonQuantity quantity;
  std::optional<LessonQuantity> less;
};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

LessonQuantity quantityOf(const std::string& term, const std::string& technique, std::size_t step,
                          const std::string& where) {
  const std::size_t blank = term.find(' ');
  LessonQuantity result{Quantity::Visibility, technique, step};
  try {
    result.quantity = quantityFrom(term.substr(0, blank), where);
    if (blank != std::string::npos)
      result.technique =
          allTechniques().make(trimmed(std::string_view(term).substr(blank)), where)->info().id;
  } catch (const Error& error) {
    throw Error(ErrorKind::BadInput, error.what());
  }
  if (infoOf(result.quantity).ofFrame)
    throw Error(ErrorKind::BadInput,
                where + ": '" + term + "' is of the whole frame; a text has numbers of the probe");
  return result;
}

Number numberOf(std::string_view inside, const std::string& technique, std::size_t step,
                const std::string& where) {
  const std::size_t minus = inside.find(" - ");
  Number number{quantityOf(trimmed(inside.substr(0, minus)), technique, step, where), {}};
  if (minus != std::string_view::npos)
    number.less = quantityOf(trimmed(inside.substr(minus + 3)), technique, step, where);
  return number;
}

// Calls `found` with each number and `text` with what stands between them.
void walk(std::string_view whole, const std::string& technique, std::size_t step,
          const std::string& where, const std::function<void(std::string_view)>& text,
          const std::function<void(const Number&)>& found) {
  while (true) {
    const std::size_t open = whole.find("{{");
    text(whole.substr(0, open));
    if (open == std::string_view::npos) return;
    const std::size_t close = whole.find("}}", open);
    if (close == std::string_view::npos)
      throw Error(ErrorKind::BadInput, where + ": '{{' has no '}}'");
    found(numberOf(whole.substr(open + 2, close - open - 2), technique, step, where));
    whole.remove_prefix(close + 2);
  }
}

}  // namespace

std::vector<LessonQuantity> quantitiesIn(std::string_view text, const std::string& technique,
                                         std::size_t step, std::string_view where) {
  std::vector<LessonQuantity> quantities;
  walk(
      text, technique, step, std::string(where), [](std::string_view) {},
      [&](const Number& number) {
        quantities.push_back(number.quantity);
        if (number.less) quantities.push_back(*number.less);
      });
  return quantities;
}

std::string filled(std::string_view text, const LessonStep& step, std::size_t index,
                   const LessonValues& values) {
  std::string result;
  walk(
      text, step.session.technique, index, step.title,
      [&](std::string_view between) { result += between; },
      [&](const Number& number) {
        const std::optional<double> value = values(number.quantity);
        const std::optional<double> less = number.less ? values(*number.less) : 0.0;
        result += value && less ? lessonNumber(*value - *less) : "…";
      });
  return result;
}

std::string lessonNumber(double value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.3g", value);
  std::string text(digits.data());
  if (text.starts_with('-')) text.replace(0, 1, "−");
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  constexpr std::string_view raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int exponent = std::stoi(text.substr(e + 1));
  std::string power = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) power += raised[digit - '0'];
  return text.substr(0, e) + "·10" + power;
}

}  // namespace umbra

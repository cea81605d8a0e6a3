#include "analysis/probe/Explain.h"

#include <algorithm>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// Counts characters and not bytes: UTF-8 continues a character with 10xxxxxx. Marks that combine
// with the letter before them, U+0300 to U+036F, take no room.
std::size_t widthOf(const std::string& text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool combining = byte == 0xCC || (byte == 0xCD && i + 1 < text.size() &&
                                            static_cast<unsigned char>(text[i + 1]) < 0xB0);
    width += (byte & 0xC0) != 0x80 && !combining;
  }
  return width;
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, widthOf(text)), ' ');
}

}  // namespace

Trace explain(const Probe& probe, const TechniqueResult& result) {
  return result.technique->explain(fetchOf(probe, result), probe.receiver);
}

std::string traceText(const Trace& trace) {
  std::size_t symbol = 0, value = 0, formula = 0;
  for (const TraceStep& step : trace.steps) {
    symbol = std::max(symbol, widthOf(step.symbol));
    value = std::max(value, widthOf(shortNumber(step.value)));
    formula = std::max(formula, widthOf(step.formula));
  }
  std::string text = trace.sentence + "\n";
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const TraceStep& step = trace.steps[i];
    text += trace.culprit == int(i) ? "→ " : "  ";
    text += padded(step.symbol, symbol) + "  " + padded(shortNumber(step.value), value) + "  " +
            padded(step.formula, formula) + "  " + step.meaning + "\n";
  }
  return text;
}

}  // namespace umbra

#include "app/lessons/Markdown.h"

#include <array>
#include <vector>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

enum class BlockKind { Paragraph, Item, Formula };

struct Block {
  BlockKind kind;
  std::string text;
};

bool isBlank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

std::vector<Block> blocksOf(std::string_view markdown) {
  std::vector<Block> blocks;
  bool fresh = true;  // after a blank line
  for (const std::string& line : split(markdown, '\n')) {
    if (isBlank(line)) {
      fresh = true;
      continue;
    }
    const bool formula = line.starts_with("    ");
    const bool item = line.starts_with("- ");
    const bool goesOn =
        !fresh && !blocks.empty() && !item && formula == (blocks.back().kind == BlockKind::Formula);
    if (goesOn)
      blocks.back().text += (formula ? "\n" + line.substr(4) : " " + line);
    else if (formula)
      blocks.push_back({BlockKind::Formula, line.substr(4)});
    else
      blocks.push_back({item ? BlockKind::Item : BlockKind::Paragraph, line.substr(item ? 2 : 0)});
    fresh = false;
  }
  return blocks;
}

// An asterisk between spaces is a product, not a mark.
bool isProduct(std::string_view text, std::size_t at) {
  const bool before = at == 0 || text[at - 1] == ' ';
  const bool after = at + 1 >= text.size() || text[at + 1] == ' ';
  return before && after;
}

struct Mark {
  std::string_view mark, open, close;
  bool on = false;
};

// Marks replaced by tags; all other characters through `literal`.
template <class Literal>
std::string inlined(std::string_view text, std::array<Mark, 3> marks, const Literal& literal) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    Mark* found = nullptr;
    for (Mark& mark : marks)
      if (!found && text.substr(i).starts_with(mark.mark)) found = &mark;
    const bool inCode = marks[0].on && found != &marks[0];
    if (!found || inCode || (found != &marks[0] && !found->on && isProduct(text, i))) {
      result += literal(text.substr(i, 1));
      ++i;
      continue;
    }
    found->on = !found->on;
    result += found->on ? found->open : found->close;
    i += found->mark.size();
  }
  for (std::size_t i = marks.size(); i-- > 0;)
    if (marks[i].on) result += marks[i].close;
  return result;
}

std::string inlineHtml(std::string_view text) {
  return inlined(
      text, {{{"`", "<code>", "</code>"}, {"**", "<strong>", "</strong>"}, {"*", "<em>", "</em>"}}},
      escapedHtml);
}

std::string inlineText(std::string_view text) {
  return inlined(text, {{{"`", "", ""}, {"**", "", ""}, {"*", "", ""}}},
                 [](std::string_view part) { return std::string(part); });
}

// Columns of UTF-8 text: bytes that begin a character.
std::size_t columnsOf(std::string_view word) {
  std::size_t columns = 0;
  for (const char c : word) columns += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return columns;
}

std::string wrapped(const std::string& text, const std::string& first, const std::string& rest,
                    std::size_t width) {
  std::string result = first;
  std::size_t column = columnsOf(first);
  bool begun = false;
  for (const std::string& word : split(text, ' ')) {
    if (word.empty()) continue;
    if (begun && column + 1 + columnsOf(word) > width) {
      result += "\n" + rest;
      column = columnsOf(rest);
      begun = false;
    }
    result += (begun ? " " : "") + word;
    column += (begun ? 1 : 0) + columnsOf(word);
    begun = true;
  }
  return result + "\n";
}

}  // namespace

std::string escapedHtml(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string markdownToHtml(std::string_view markdown) {
  std::string html;
  bool inList = false;
  for (const Block& block : blocksOf(markdown)) {
    const bool item = block.kind == BlockKind::Item;
    if (item != inList) html += item ? "<ul>\n" : "</ul>\n";
    inList = item;
    if (block.kind == BlockKind::Formula)
      html += "<pre class=\"formula\">" + escapedHtml(block.text) + "</pre>\n";
    else
      html += (item ? "<li>" : "<p>") + inlineHtml(block.text) + (item ? "</li>\n" : "</p>\n");
  }
  return html + (inList ? "</ul>\n" : "");
}

std::string markdownToText(std::string_view markdown, std::size_t width) {
  std::string text;
  BlockKind before = BlockKind::Paragraph;
  for (const Block& block : blocksOf(markdown)) {
    const bool item = block.kind == BlockKind::Item;
    if (!text.empty() && !(item && before == BlockKind::Item)) text += "\n";
    before = block.kind;
    if (block.kind == BlockKind::Formula)
      for (const std::string& line : split(block.text, '\n')) text += "    " + line + "\n";
    else
      text += wrapped(inlineText(block.text), item ? "- " : "", item ? "  " : "", width);
  }
  return text;
}

}  // namespace umbra

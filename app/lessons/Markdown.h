// The part of Markdown that lessons are written in, as HTML and as plain text: paragraphs, lists of
// lines that begin with "- ", formulas indented by four spaces, **strong**, *emphasis*, `code`.
#pragma once

#include <string>
#include <string_view>

namespace umbra {

// Text with &, <, > and quotes as HTML has them.
std::string escapedHtml(std::string_view text);

// Blocks of HTML; formulas as <pre class="formula">. Whatever is not closed ends with its block.
std::string markdownToHtml(std::string_view markdown);

// The same for a terminal: marks taken out, paragraphs wrapped at `width` columns.
std::string markdownToText(std::string_view markdown, std::size_t width = 78);

}  // namespace umbra

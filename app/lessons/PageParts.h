// Parts of pages of HTML that need nothing beside themselves: lessons, reports.
#pragma once

#include <string>
#include <string_view>

namespace umbra {

// From the document's type to the start of its body. `style` follows the style of all pages.
std::string pageStart(const std::string& title, std::string_view style = {});

// A PNG as a figure with its caption, which is also what is read out in its place.
std::string pictureInPage(std::string_view png, const std::string& caption);

}  // namespace umbra

// A technique's page as it is read: its text with the table of its parameters.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "filters/core/technique/Technique.h"

namespace umbra {

// Markdown: Technique::page() with a table of the parameters, made from their fields, before its
// sources.
std::string pageOf(const Technique& technique);

// What a parameter may be: "0 … 1", "uniform|manual|lloyd".
std::string rangeText(const ParameterView& parameter);

// The names of the pictures that a page shows, in their order: ![what is seen](Vsm.png).
std::vector<std::string> pictureNames(std::string_view page);

// A picture that pages show, as PNG, by the name that they give it: "Vsm.png". Empty where there is
// none of that name.
std::span<const unsigned char> pagePicture(std::string_view name);

}  // namespace umbra

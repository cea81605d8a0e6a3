// How a claim in a file says that two figures stand to each other.
#pragma once

#include <string>

namespace umbra {

enum class Relation { Less, Greater, Near };

// "<", ">" or "≈".
const char* nameOf(Relation relation);
// Throws BadInput that begins with `where` for any other name.
Relation relationFrom(const std::string& name, const std::string& where);

}  // namespace umbra

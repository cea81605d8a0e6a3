// Aligned tables for people.
#pragma once

#include <string>
#include <vector>

namespace umbra {

using TableRow = std::vector<std::string>;

// The first row is the heading. Columns that hold only numbers are aligned to the right, widths
// count characters, not bytes. Ends with a newline.
std::string tableText(const std::vector<TableRow>& rows);

}  // namespace umbra

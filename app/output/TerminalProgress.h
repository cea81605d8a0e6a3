// Long work tells on the terminal how far it has come, and Ctrl+C stops it.
#pragma once

#include <string>

#include "filters/core/support/Progress.h"

namespace umbra {

// Says "reading NAME: 40 %" on standard error where that is a terminal and the work takes more than
// a moment; the line is gone when the work is done. Throws Cancelled once a stop was asked for.
Progress progressOnTerminal(const std::string& name);
// Says "cell 12 of 200, 3 min left" likewise. The time is that of the cells since `done` of them
// were there.
Progress progressOfCells(std::size_t count, std::size_t done);

}  // namespace umbra

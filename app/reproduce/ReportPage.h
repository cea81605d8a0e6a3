// The report of the papers' figures as one page of HTML that needs nothing beside itself.
#pragma once

#include <string>
#include <vector>

#include "app/reproduce/FigureResult.h"

namespace umbra {

// Pictures are data URIs. `leftOut` are figures that are not done, each with its reason.
std::string reportPage(const std::vector<FigureResult>& results,
                       const std::vector<Figure>& leftOut);

}  // namespace umbra

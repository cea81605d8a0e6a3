// The papers' figures that the program brings: the files of datasets/figures.
#pragma once

#include <string>
#include <vector>

#include "datasets/figures/Figure.h"

namespace umbra {

// All figures by their names, 3.10 after 3.9; what is left out as well.
std::vector<Figure> figureCatalogue();

// The figure of this name in the catalogue or, where `name` ends in ".json", somebody's own file.
// Throws BadCommandLine for an unknown name, with the nearest one, and as readFigure does.
Figure figureNamed(const std::string& name);

}  // namespace umbra

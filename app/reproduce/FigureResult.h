// A figure of a paper, drawn and measured here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/output/Output.h"
#include "datasets/figures/Figure.h"
#include "datasets/figures/FigureVerdict.h"

namespace umbra {

struct FigureResult {
  Figure figure;
  std::vector<Json> rows;             // of its cells, as SweepRunner measures them
  std::vector<std::string> pictures;  // PNG of each cell, "" where it has none
  std::vector<ClaimVerdict> claims;   // as in the figure
  double seconds = 0.0;               // that all this took
};

// `beforeCell` is called before each cell, and may throw Cancelled.
FigureResult measuredFigure(const Figure& figure, const std::function<void()>& beforeCell);

// "NAME-CELL.png": what the picture of a cell is called beside the report.
std::string pictureNameOf(const Figure& figure, std::size_t cell);
// What repeats the figure alone.
std::string commandOf(const Figure& figure);

// {"format": "umbrascope-report/1", "figures": […], "leftOut": […]}
Json reportToJson(const std::vector<FigureResult>& results, const std::vector<Figure>& leftOut);

}  // namespace umbra

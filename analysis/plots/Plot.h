// A plot as plain data: drawn in the window, and written as SVG, PDF, PNG and CSV, from this one
// description.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace umbra {

enum class SeriesStyle {
  Line,    // straight between the points
  Steps,   // holds each value until the next x
  Bars,    // x has one more value than y: the edges
  Points,  // separate marks
};

struct PlotSeries {
  std::string name;    // for the legend; "" leaves it out
  std::string colour;  // "#rrggbb"
  SeriesStyle style = SeriesStyle::Line;
  std::vector<double> x, y;
  double lineWidth = 1.5;  // points
  bool dashed = false;
};

enum class MarkerAxis { Vertical, Horizontal };

// A line across the whole plot, such as the receiver's depth.
struct PlotMarker {
  MarkerAxis axis = MarkerAxis::Vertical;  // Vertical: at x = position
  double position = 0.0;
  std::string label;
  std::string colour;
  bool dashed = true;
  bool draggable = false;  // a window lets it be dragged along its axis
};

// A stretch of x behind the series, such as a layer of depth.
struct PlotBand {
  double low = 0.0, high = 1.0;
  std::string name;  // the text that is shown for an x within the band
  std::string colour;
  bool hatched = false;  // hatched; otherwise filled
};

// A thick bar from (x, from) to (x, to): the error at the receiver.
struct PlotError {
  double x = 0.0, from = 0.0, to = 0.0;
  std::string label;
  std::string colour;
};

struct PlotRange {
  double low = 0.0, high = 1.0;
};

struct Plot {
  std::string name;  // for file names: "curves", "histogram", "cdf"
  std::string title;
  std::string xLabel, yLabel;
  std::optional<PlotRange> xRange, yRange;  // fitted to the data where not set
  bool wholeX = false;                      // x counts something: ticks at whole numbers only
  std::vector<PlotSeries> series;
  std::vector<PlotMarker> markers;
  std::vector<PlotError> errors;
  std::vector<PlotBand> bands;  // in drawing order
};

// One column of x and one of y for every series, with a header line; series that share their x
// share its column. Numbers are the shortest that read back exactly. Throws BadOutput; nothing
// half-written.
void writeCsv(const Plot& plot, const std::filesystem::path& file);
std::string toCsv(const Plot& plot);

}  // namespace umbra

// Draws analysis/plots/Plot.h with Qwt: on a widget, and into SVG, PDF and PNG files.
#pragma once

#include <QSize>
#include <filesystem>
#include <string>

#include "analysis/plots/Plot.h"

class QwtPlot;
class QImage;

namespace umbra {

// Replaces everything on `widget` by `plot`.
void showPlot(QwtPlot& widget, const Plot& plot);

// Writes what the file's extension says: .svg, .pdf (text stays text) or .png. `size` is in points;
// a PNG has twice as many pixels. Needs a QApplication (the "offscreen" platform will do). Throws
// BadOutput, and leaves no half-written file.
void exportPlot(const Plot& plot, const std::filesystem::path& file, QSize size = {720, 440});
// What exportPlot writes as .svg.
std::string plotSvg(const Plot& plot, QSize size = {720, 440});
QImage plotImage(const Plot& plot, QSize size, double pixelRatio = 2.0);

}  // namespace umbra

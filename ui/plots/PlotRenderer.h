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

// By extension: .svg, .pdf (text stays text) or .png; `size` in points, PNG at twice that. Needs a
// QApplication (the "offscreen" platform serves). Throws BadOutput; nothing half-written.
void exportPlot(const Plot& plot, const std::filesystem::path& file, QSize size = {720, 440});
// What exportPlot writes as .svg.
std::string plotSvg(const Plot& plot, QSize size = {720, 440});
QImage plotImage(const Plot& plot, QSize size, double pixelRatio = 2.0);

}  // namespace umbra

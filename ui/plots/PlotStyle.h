// How every plot looks: fonts, colours, axes and grid.
#pragma once

#include <QColor>
#include <string>

class QwtPlot;
class QwtText;

namespace umbra {

enum class TextRole { Title, AxisTitle, Tick, Legend, Label, ErrorLabel };

// `text` in the font of its role; without a colour in the role's own.
QwtText styledText(const std::string& text, TextRole role, const QColor& colour = {});

// Pixels that one row takes of a plot's labels and of its legend.
double labelHeight();
double legendRowHeight();

// White ground, light grid, thin axes; numbers in the C locale with as many decimals as the step
// between ticks needs. Attaches a grid item.
void applyPlotStyle(QwtPlot& widget);

// The number of labelled ticks that a plot of the widget's size has room for.
void fitTickCount(QwtPlot& widget);

}  // namespace umbra

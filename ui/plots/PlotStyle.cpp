#include "ui/plots/PlotStyle.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>
#include <qwt_text_label.h>

#include <QApplication>
#include <QFontMetricsF>
#include <QPalette>
#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

const QColor inkColour(0x1f, 0x29, 0x33);
const QColor quietColour(0x52, 0x60, 0x6d);
const QColor axisColour(0x9a, 0xa5, 0xb1);
const QColor gridColour(0xe8, 0xeb, 0xef);

QFont fontOf(TextRole role) {
  QFont font = QApplication::font();
  const bool title = role == TextRole::Title;
  font.setPointSizeF(title ? 9.0 : role == TextRole::AxisTitle ? 8.5 : 8.0);
  font.setBold(title || role == TextRole::ErrorLabel);
  return font;
}

// QwtScaleDraw would write in the user's locale; the labels inside the plot, tables and files
// have a decimal point everywhere.
class TickLabels final : public QwtScaleDraw {
 public:
  TickLabels() {
    setTickLength(QwtScaleDiv::MinorTick, 0.0);
    setTickLength(QwtScaleDiv::MediumTick, 0.0);
    setTickLength(QwtScaleDiv::MajorTick, 4.0);
    setSpacing(3.0);
  }

  QwtText label(double value) const override {
    const QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
    const double step = ticks.size() > 1 ? std::abs(ticks[1] - ticks[0]) : 1.0;
    int decimals = 0;
    for (double scaled = step; decimals < 6 && std::abs(scaled - std::round(scaled)) > 1e-6;
         scaled *= 10.0)
      ++decimals;
    // 0.15 − 0.05 · 3 is not quite zero.
    return QString::number(std::abs(value) < step * 1e-6 ? 0.0 : value, 'f', decimals);
  }
};

void styleAxis(QwtPlot& widget, int axis) {
  widget.setAxisScaleDraw(axis, new TickLabels);
  widget.setAxisFont(axis, fontOf(TextRole::Tick));
  QPalette palette = widget.axisWidget(axis)->palette();
  palette.setColor(QPalette::WindowText, axisColour);
  palette.setColor(QPalette::Text, quietColour);
  widget.axisWidget(axis)->setPalette(palette);
  widget.axisWidget(axis)->setMargin(0);
  widget.axisWidget(axis)->setSpacing(3);
}

}  // namespace

QwtText styledText(const std::string& text, TextRole role, const QColor& colour) {
  // As plain text: names may hold "<".
  QwtText styled(QString::fromStdString(text), QwtText::PlainText);
  styled.setFont(fontOf(role));
  const bool strong = role == TextRole::Title || role == TextRole::Legend;
  styled.setColor(colour.isValid() ? colour : strong ? inkColour : quietColour);
  return styled;
}

double labelHeight() {
  return QFontMetricsF(fontOf(TextRole::Label)).height() + 1.0;
}

double legendRowHeight() {
  return QFontMetricsF(fontOf(TextRole::Legend)).height() + 6.0;
}

void applyPlotStyle(QwtPlot& widget) {
  widget.setAutoFillBackground(true);
  QPalette palette = widget.palette();
  palette.setColor(QPalette::Window, Qt::white);
  widget.setPalette(palette);
  widget.setContentsMargins(4, 4, 12, 4);  // the last tick label reaches beyond its axis
  widget.setCanvasBackground(Qt::white);
  if (auto* canvas = qobject_cast<QwtPlotCanvas*>(widget.canvas())) {
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setBorderRadius(0.0);
  }

  widget.plotLayout()->setAlignCanvasToScales(true);
  widget.plotLayout()->setCanvasMargin(0);
  widget.plotLayout()->setSpacing(4);
  for (int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) styleAxis(widget, axis);
  auto* grid = new QwtPlotGrid;
  grid->enableX(false);
  grid->setMajorPen(gridColour, 1.0);
  grid->attach(&widget);
}

void fitTickCount(QwtPlot& widget) {
  // Pixels that a label and the space around it take.
  const int across = 45, down = 26;
  widget.setAxisMaxMajor(QwtPlot::xBottom, std::clamp((widget.width() - 60) / across, 2, 10));
  widget.setAxisMaxMajor(QwtPlot::yLeft, std::clamp((widget.height() - 80) / down, 2, 10));
}

}  // namespace umbra

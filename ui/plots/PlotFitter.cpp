#include "ui/plots/PlotFitter.h"

#include <qwt_legend.h>
#include <qwt_legend_data.h>
#include <qwt_plot.h>
#include <qwt_plot_item.h>

#include <QEvent>
#include <algorithm>
#include <cmath>

#include "ui/plots/PlotStyle.h"

namespace umbra {
namespace {

constexpr char fitterName[] = "umbra-plot-fitter";
constexpr double iconWidth = 34.0;                     // pixels, with the spaces around it
constexpr double axisWidth = 55.0, axisHeight = 60.0;  // pixels: what lies around the curves

// Pixels of the largest entry, and how many there are.
struct LegendExtent {
  int entries = 0;
  QSizeF entry;
};

LegendExtent extentOf(const QwtPlot& widget) {
  LegendExtent extent;
  for (const QwtPlotItem* item : widget.itemList()) {
    if (!item->testItemAttribute(QwtPlotItem::Legend)) continue;
    ++extent.entries;
    const QSizeF text = item->title().textSize(item->title().font());
    extent.entry = extent.entry.expandedTo(text + QSizeF(iconWidth, 2.0));
  }
  return extent;
}

QwtPlot::LegendPosition betterPosition(const QwtPlot& widget, const LegendExtent& legend) {
  const double width = std::max(1.0, widget.width() - axisWidth);
  const double height = std::max(1.0, widget.height() - axisHeight);
  const double columns = std::max(1.0, std::floor(widget.width() / legend.entry.width()));
  const double below = std::ceil(legend.entries / columns) * legend.entry.height();
  const bool fitsBeside = legend.entries * legend.entry.height() <= height + axisHeight / 2;
  const double roomBeside = fitsBeside ? (width - legend.entry.width()) * height : 0.0;
  const double roomBelow = width * (height - below);
  return roomBeside > roomBelow ? QwtPlot::RightLegend : QwtPlot::BottomLegend;
}

}  // namespace

PlotFitter& PlotFitter::of(QwtPlot& widget) {
  if (QObject* child = widget.findChild<QObject*>(fitterName, Qt::FindDirectChildrenOnly))
    return static_cast<PlotFitter&>(*child);
  return *new PlotFitter(widget);  // owned by the widget
}

PlotFitter::PlotFitter(QwtPlot& widget) : QObject(&widget), widget_(widget) {
  setObjectName(fitterName);
  widget.installEventFilter(this);
}

bool PlotFitter::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize) fit();
  return QObject::eventFilter(object, event);
}

void PlotFitter::fit() {
  fitTickCount(widget_);
  const LegendExtent extent = extentOf(widget_);
  if (extent.entries == 0) {
    widget_.insertLegend(nullptr);
    return;
  }
  auto* legend = qobject_cast<QwtLegend*>(widget_.legend());
  if (!legend) {
    legend = new QwtLegend;
    legend->setFrameStyle(QFrame::NoFrame);
    legend->setDefaultItemMode(QwtLegendData::ReadOnly);
  }
  widget_.insertLegend(legend, betterPosition(widget_, extent), 0.6);
}

}  // namespace umbra

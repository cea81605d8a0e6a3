#include "ui/plots/PlotFitter.h"

#include <qwt_legend.h>
#include <qwt_legend_data.h>
#include <qwt_legend_label.h>
#include <qwt_plot.h>
#include <qwt_plot_item.h>

#include <QEvent>
#include <QFontMetrics>
#include <QLayout>
#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "ui/plots/PlotStyle.h"

namespace umbra {
namespace {

constexpr char fitterName[] = "umbra-plot-fitter";
constexpr double iconWidth = 30.0;                     // pixels, with the spaces around it
constexpr double axisWidth = 70.0, axisHeight = 70.0;  // pixels: what lies around the curves
constexpr double leastHeight = 60.0;  // pixels of the curves under which no legend fits

// Pixels of every entry, in the legend's order.
std::vector<double> entryWidths(const QwtPlot& widget) {
  std::vector<double> widths;
  for (const QwtPlotItem* item : widget.itemList())
    if (item->testItemAttribute(QwtPlotItem::Legend))
      widths.push_back(item->title().textSize(item->title().font()).width() + iconWidth);
  return widths;
}

// Counts the rows as QwtDynGridLayout does: it takes the most columns whose widest entries fit
// beside one another.
std::size_t rowsWithin(const std::vector<double>& entries, double width) {
  for (std::size_t columns = entries.size(); columns > 1; --columns) {
    std::vector<double> widest(columns, 0.0);
    for (std::size_t i = 0; i < entries.size(); ++i)
      widest[i % columns] = std::max(widest[i % columns], entries[i]);
    if (std::accumulate(widest.begin(), widest.end(), 0.0) <= width)
      return (entries.size() + columns - 1) / columns;
  }
  return entries.size();
}

std::optional<QwtPlot::LegendPosition> legendPosition(const QwtPlot& widget) {
  const std::vector<double> entries = entryWidths(widget);
  if (entries.empty()) return std::nullopt;
  const double row = legendRowHeight();
  const double width = widget.width() - axisWidth, height = widget.height() - axisHeight;
  const double heightBelow = height - double(rowsWithin(entries, widget.width())) * row;
  const double widthBeside = width - *std::max_element(entries.begin(), entries.end());
  const bool fitsBeside = double(entries.size()) * row <= height + axisHeight / 2;
  const double roomBelow = heightBelow >= leastHeight ? width * heightBelow : 0.0;
  const double roomBeside = fitsBeside && widthBeside >= width / 2 ? widthBeside * height : 0.0;
  if (roomBelow == 0.0 && roomBeside == 0.0) return std::nullopt;
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

void PlotFitter::setPlot(const Plot& plot) {
  plot_ = plot;
  fit();
}

void PlotFitter::fit() {
  fitTickCount(widget_);
  fitLegend();
  fitTitles();
  fitScales();
  widget_.replot();
}

void PlotFitter::fitLegend() {
  const auto position = legendPosition(widget_);
  if (!position) {
    widget_.insertLegend(nullptr);
    return;
  }
  auto* legend = qobject_cast<QwtLegend*>(widget_.legend());
  if (!legend) {
    legend = new QwtLegend;
    legend->setFrameStyle(QFrame::NoFrame);
    legend->setDefaultItemMode(QwtLegendData::ReadOnly);
    legend->contentsWidget()->layout()->setSpacing(4);
    legend->contentsWidget()->layout()->setContentsMargins(0, 0, 0, 0);
  }
  widget_.insertLegend(legend, *position, 0.6);
  for (QwtLegendLabel* label : legend->findChildren<QwtLegendLabel*>()) {
    label->setMargin(1);
    // Qwt stops a label's updates while it sets the label, and for good where they were stopped
    // already: as in a stack of pages that turns to the plot.
    label->setUpdatesEnabled(true);
  }
}

void PlotFitter::fitTitles() {
  const QwtText yTitle = styledText(plot_.yLabel, TextRole::AxisTitle);
  const QwtText xTitle = styledText(plot_.xLabel, TextRole::AxisTitle);
  widget_.setAxisTitle(QwtPlot::xBottom, xTitle);
  widget_.setAxisTitle(QwtPlot::yLeft, yTitle);
  widget_.setTitle(styledText(plot_.title, TextRole::Title));
  widget_.updateLayout();
  const QSize canvas = widget_.canvas()->size();
  if (xTitle.textSize(xTitle.font()).width() > canvas.width())
    widget_.setAxisTitle(QwtPlot::xBottom, QwtText());
  if (yTitle.textSize(yTitle.font()).width() > canvas.height())
    widget_.setAxisTitle(QwtPlot::yLeft, QwtText());
  QwtText title = widget_.title();
  title.setText(
      QFontMetrics(title.font()).elidedText(title.text(), Qt::ElideRight, canvas.width()));
  widget_.setTitle(title);
  widget_.updateLayout();
}

// The step between x ticks where they are to be whole numbers: 1, 2, 5, 10 …; else 0, Qwt's choice.
double PlotFitter::wholeStep() const {
  if (!plot_.wholeX) return 0.0;
  const double wanted = (plot_.xRange->high - plot_.xRange->low) /
                        std::max(1, widget_.axisMaxMajor(QwtPlot::xBottom));
  for (double power = 1.0;; power *= 10.0)
    for (double step : {1.0, 2.0, 5.0})
      if (step * power >= wanted) return step * power;
}

// Above the range lies a strip for the markers' labels, where no curve runs.
void PlotFitter::fitScales() {
  if (plot_.xRange)
    widget_.setAxisScale(QwtPlot::xBottom, plot_.xRange->low, plot_.xRange->high, wholeStep());
  else
    widget_.setAxisAutoScale(QwtPlot::xBottom);
  if (!plot_.yRange) {
    widget_.setAxisAutoScale(QwtPlot::yLeft);
    return;
  }
  const int rows = plot_.markers.empty() ? 0 : plot_.markers.size() > 2 ? 2 : 1;
  const double height = std::max(1, widget_.canvas()->height());
  const double strip = std::min(rows * labelHeight(), 0.4 * height);
  const double range = plot_.yRange->high - plot_.yRange->low;
  widget_.setAxisScale(QwtPlot::yLeft, plot_.yRange->low,
                       plot_.yRange->low + range * height / (height - strip));
}

}  // namespace umbra

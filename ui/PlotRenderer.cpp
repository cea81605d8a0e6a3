#include "ui/PlotRenderer.h"

#include <qwt_plot.h>
#include <qwt_plot_renderer.h>

#include <QImage>
#include <QImageWriter>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <cmath>

#include "filters/core/AtomicFile.h"
#include "filters/core/Error.h"
#include "ui/plots/AnnotationItem.h"
#include "ui/plots/PlotFitter.h"
#include "ui/plots/PlotStyle.h"
#include "ui/plots/SeriesItem.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr double pointsPerInch = 72.0;

void attachSeries(QwtPlot& widget, const PlotSeries& series, double z, bool inLegend) {
  auto* item = new SeriesItem(series);  // owned by the widget
  item->setItemAttribute(QwtPlotItem::Legend, inLegend && !series.name.empty());
  item->setZ(z);
  item->attach(&widget);
}

void setRange(QwtPlot& widget, int axis, const std::optional<PlotRange>& range) {
  if (range)
    widget.setAxisScale(axis, range->low, range->high);
  else
    widget.setAxisAutoScale(axis);
}

void draw(QwtPlot& widget, QPainter& painter, QSize size) {
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasBackground);
  renderer.render(&widget, &painter, QRectF(QPointF(0, 0), QSizeF(size)));
}

// A widget, never shown, of the size on screen that `size` points have on paper.
std::unique_ptr<QwtPlot> hiddenWidget(const Plot& plot, QSize size) {
  auto widget = std::make_unique<QwtPlot>();
  widget->resize(int(std::lround(size.width() * widget->logicalDpiX() / pointsPerInch)),
                 int(std::lround(size.height() * widget->logicalDpiY() / pointsPerInch)));
  showPlot(*widget, plot);
  return widget;
}

[[noreturn]] void refuse(const std::string& reason) {
  throw std::runtime_error(reason);
}

void writeSvg(QwtPlot& widget, const Plot& plot, const QString& file, QSize size) {
  QSvgGenerator generator;
  generator.setFileName(file);
  generator.setResolution(int(pointsPerInch));
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(QString::fromStdString(plot.title));
  QPainter painter;
  if (!painter.begin(&generator)) refuse("the file cannot be opened");
  painter.fillRect(QRect(QPoint(0, 0), size), Qt::white);
  draw(widget, painter, size);
  if (!painter.end()) refuse("writing stopped");
}

void writePdf(QwtPlot& widget, const Plot& plot, const QString& file, QSize size) {
  QPdfWriter writer(file);
  writer.setTitle(QString::fromStdString(plot.title));
  writer.setResolution(int(pointsPerInch));
  writer.setPageSize(QPageSize(QSizeF(size), QPageSize::Point, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  QPainter painter;
  if (!painter.begin(&writer)) refuse("the file cannot be opened");
  draw(widget, painter, size);
  if (!painter.end()) refuse("writing stopped");
}

void writePng(const Plot& plot, const QString& file, QSize size) {
  QImageWriter writer(file, "png");
  if (!writer.write(plotImage(plot, size))) refuse(writer.errorString().toStdString());
}

}  // namespace

void showPlot(QwtPlot& widget, const Plot& plot) {
  widget.setAutoReplot(false);
  widget.detachItems(QwtPlotItem::Rtti_PlotItem, true);
  applyPlotStyle(widget);
  widget.setTitle(styledText(plot.title, TextRole::Title));
  widget.setAxisTitle(QwtPlot::xBottom, styledText(plot.xLabel, TextRole::AxisTitle));
  widget.setAxisTitle(QwtPlot::yLeft, styledText(plot.yLabel, TextRole::AxisTitle));
  setRange(widget, QwtPlot::xBottom, plot.xRange);
  setRange(widget, QwtPlot::yLeft, plot.yRange);
  // A single series is named by the title.
  const bool inLegend = plot.series.size() > 1;
  double z = 10.0;
  for (const PlotSeries& series : plot.series) attachSeries(widget, series, z += 0.1, inLegend);
  (new AnnotationItem(plot))->attach(&widget);
  PlotFitter::of(widget).fit();
  widget.replot();
}

QImage plotImage(const Plot& plot, QSize size, double pixelRatio) {
  const std::unique_ptr<QwtPlot> widget = hiddenWidget(plot, size);
  const QSize pixels = (QSizeF(size) * pixelRatio).toSize();
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  const int dotsPerMetre = int(std::lround(pointsPerInch * pixelRatio / 0.0254));
  image.setDotsPerMeterX(dotsPerMetre);
  image.setDotsPerMeterY(dotsPerMetre);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  draw(*widget, painter, pixels);
  return image;
}

void exportPlot(const Plot& plot, const fs::path& file, QSize size) {
  const std::string extension = file.extension().string();
  if (extension != ".svg" && extension != ".pdf" && extension != ".png")
    throw Error(ErrorKind::BadOutput, file.string() + ": a plot is written as .svg, .pdf or .png");
  const std::unique_ptr<QwtPlot> widget = hiddenWidget(plot, size);
  writeAtomically(file, [&](const fs::path& temporary) {
    const QString path = QString::fromStdString(temporary.string());
    if (extension == ".svg") writeSvg(*widget, plot, path, size);
    if (extension == ".pdf") writePdf(*widget, plot, path, size);
    if (extension == ".png") writePng(plot, path, size);
  });
}

}  // namespace umbra

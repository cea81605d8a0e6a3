#include "ui/plots/PlotRenderer.h"

#include <qwt_plot.h>
#include <qwt_plot_renderer.h>

#include <QBuffer>
#include <QDateTime>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <algorithm>
#include <cmath>
#include <memory>

#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "ui/plots/AnnotationItem.h"
#include "ui/plots/BandItem.h"
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

void draw(QwtPlot& widget, QPainter& painter, QSize size) {
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasBackground);
  // Tick labels reach beyond their axes.
  const double margin = 0.012 * size.width();
  renderer.render(&widget, &painter,
                  QRectF(QPointF(0, 0), QSizeF(size)).adjusted(margin / 2, margin / 2, -margin, 0));
}

// A widget, never shown, of the size on screen that `size` points have on paper.
std::unique_ptr<QwtPlot> hiddenWidget(const Plot& plot, QSize size) {
  auto widget = std::make_unique<QwtPlot>();
  widget->resize(int(std::lround(size.width() * widget->logicalDpiX() / pointsPerInch)),
                 int(std::lround(size.height() * widget->logicalDpiY() / pointsPerInch)));
  showPlot(*widget, plot);
  return widget;
}

void drawOn(QPaintDevice& device, QwtPlot& widget, QSize size) {
  QPainter painter;
  if (!painter.begin(&device)) throw Error(ErrorKind::WorkFailed, "a plot cannot be drawn");
  painter.setRenderHint(QPainter::Antialiasing);
  // QPdfWriter's pages are white already, and a rectangle less keeps its files editable.
  if (!dynamic_cast<QPdfWriter*>(&device)) painter.fillRect(QRect(QPoint(0, 0), size), Qt::white);
  draw(widget, painter, size);
}

// Files are drawn in memory, since Qt's generators do not notice a full disk.
QByteArray svgOf(const Plot& plot, QSize size) {
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(int(pointsPerInch));
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(QString::fromStdString(plot.title));
  drawOn(generator, *hiddenWidget(plot, size), size);
  return buffer.data();
}

// A PDF tells when it was made. Where SOURCE_DATE_EPOCH is set (reproducible-builds.org) it tells
// that time, so that the same plot is the same file. Qt writes a date as
// "/CreationDate (D:20260131235959Z)", with an offset in place of Z elsewhere than in UTC.
void setSourceDate(QByteArray& pdf) {
  bool isSet = false;
  const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isSet);
  const QByteArray key = "/CreationDate (D:";
  const int at = isSet ? pdf.indexOf(key) : -1;
  const int end = at < 0 ? -1 : pdf.indexOf(')', at);
  if (end < 0) return;
  // The table of the file's objects counts bytes: the length stays.
  const int start = at + key.size(), length = end - start;
  const QByteArray date =
      QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC).toString("yyyyMMddHHmmss").toLatin1() +
      (length > 15 ? "+00'00'" : "Z");
  if (date.size() == length) pdf.replace(start, length, date);
}

QByteArray pdfOf(const Plot& plot, QSize size) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(QString::fromStdString(plot.title));
  writer.setResolution(int(pointsPerInch));
  writer.setPageSize(QPageSize(QSizeF(size), QPageSize::Point, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  drawOn(writer, *hiddenWidget(plot, size), size);
  setSourceDate(buffer.buffer());
  return buffer.data();
}

QByteArray pngOf(const Plot& plot, QSize size) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  plotImage(plot, size).save(&buffer, "PNG");
  return buffer.data();
}

}  // namespace

void showPlot(QwtPlot& widget, const Plot& plot) {
  widget.setAutoReplot(false);
  widget.detachItems(QwtPlotItem::Rtti_PlotItem, true);
  applyPlotStyle(widget);
  for (const PlotBand& band : plot.bands) (new BandItem(band))->attach(&widget);
  // A single series is named by the title.
  const bool inLegend = std::count_if(plot.series.begin(), plot.series.end(),
                                      [](const auto& one) { return !one.name.empty(); }) > 1;
  double z = 10.0;
  for (const PlotSeries& series : plot.series) attachSeries(widget, series, z += 0.1, inLegend);
  (new AnnotationItem(plot))->attach(&widget);
  PlotFitter::of(widget).setPlot(plot);
}

QImage plotImage(const Plot& plot, QSize size, double pixelRatio) {
  const QSize pixels = (QSizeF(size) * pixelRatio).toSize();
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  const int dotsPerMetre = int(std::lround(pointsPerInch * pixelRatio / 0.0254));
  image.setDotsPerMeterX(dotsPerMetre);
  image.setDotsPerMeterY(dotsPerMetre);
  drawOn(image, *hiddenWidget(plot, size), pixels);
  return image;
}

std::string plotSvg(const Plot& plot, QSize size) {
  return svgOf(plot, size).toStdString();
}

void exportPlot(const Plot& plot, const fs::path& file, QSize size) {
  const std::string extension = file.extension().string();
  QByteArray content;
  if (extension == ".svg")
    content = svgOf(plot, size);
  else if (extension == ".pdf")
    content = pdfOf(plot, size);
  else if (extension == ".png")
    content = pngOf(plot, size);
  else
    throw Error(ErrorKind::BadOutput, file.string() + ": a plot is written as .svg, .pdf or .png");
  writeTextAtomically(file, {content.constData(), std::size_t(content.size())});
}

}  // namespace umbra

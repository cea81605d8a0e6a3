#include "ui/widgets/plots/PlotPane.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QStackedLayout>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Error.h"
#include "ui/plots/PlotRenderer.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/plots/PlotReadout.h"

namespace umbra {
namespace {

constexpr double grabDistance = 6.0;  // pixels to either side of a marker

QToolButton* headerButton(const QString& text, const QString& toolTip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(toolTip);
  button->setAutoRaise(true);
  return button;
}

}  // namespace

PlotPane::PlotPane(const QString& title, QWidget* parent)
    : Card(title, parent), widget_(new QwtPlot), hint_(new QLabel), pages_(new QStackedLayout) {
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  QPalette grey = hint_->palette();
  grey.setColor(QPalette::WindowText, style::muted);
  hint_->setPalette(grey);
  widget_->setMinimumSize(120, 90);
  widget_->canvas()->setMouseTracking(true);
  widget_->canvas()->installEventFilter(this);
  widget_->axisWidget(QwtPlot::xBottom)->installEventFilter(this);
  pages_->addWidget(hint_);
  pages_->addWidget(widget_);
  body()->addLayout(pages_, 1);

  auto* copyButton = headerButton(tr("Copy"), tr("Copy the plot as a picture"));
  auto* saveButton = headerButton(tr("Save…"), tr("Save as SVG, PDF, PNG or CSV"));
  addToHeader(copyButton);
  addToHeader(saveButton);
  connect(copyButton, &QToolButton::clicked, this, &PlotPane::copy);
  connect(saveButton, &QToolButton::clicked, this, &PlotPane::saveAs);
}

void PlotPane::setPlot(const Plot& plot) {
  plot_ = plot;
  setTitle(QString::fromStdString(plot.title));
  // The card says the title already.
  Plot untitled = plot;
  untitled.title.clear();
  showPlot(*widget_, untitled);
  fitAxisTitle();
  QWidget* axis = widget_->axisWidget(QwtPlot::xBottom);
  axis->setCursor(receiver() ? Qt::SplitHCursor : Qt::ArrowCursor);
  axis->setToolTip(receiver() ? tr("Drag along the axis to move the receiver") : QString());
  pages_->setCurrentWidget(widget_);
}

void PlotPane::fitAxisTitle() {
  if (!plot_) return;
  QwtText title = widget_->axisTitle(QwtPlot::xBottom);
  const QFontMetrics metrics(title.font());
  title.setText(metrics.elidedText(QString::fromStdString(plot_->xLabel), Qt::ElideRight,
                                   widget_->canvas()->width() - 4));
  widget_->setAxisTitle(QwtPlot::xBottom, title);
}

void PlotPane::clear(const QString& hint) {
  plot_.reset();
  dragged_.reset();
  hint_->setText(hint);
  pages_->setCurrentWidget(hint_);
}

void PlotPane::save(const std::filesystem::path& file) const {
  if (!plot_) throw Error(ErrorKind::WorkFailed, "there is no plot to save yet");
  if (file.extension() == ".csv")
    writeCsv(*plot_, file);
  else
    exportPlot(*plot_, file);
}

void PlotPane::copy() const {
  if (!plot_) return;
  QGuiApplication::clipboard()->setImage(plotImage(*plot_, widget_->size()));
}

void PlotPane::saveAs() {
  if (!plot_) return;
  QString chosen;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save plot"), QString::fromStdString(plot_->name) + ".svg",
      tr("SVG (*.svg);;PDF (*.pdf);;PNG (*.png);;CSV (*.csv)"), &chosen);
  if (file.isEmpty()) return;
  try {
    save(file.toStdString());
    emit message(tr("Saved %1").arg(file));
  } catch (const Error& error) {
    emit message(QString::fromStdString(error.what()));
  }
}

// Whether a draggable marker is the receiver's, which has the probe's colour wherever it is shown.
bool PlotPane::isReceiver(int marker) const {
  return plot_->markers[std::size_t(marker)].colour == probeColour;
}

std::optional<int> PlotPane::receiver() const {
  for (int i = 0; plot_ && i < int(plot_->markers.size()); ++i) {
    const PlotMarker& marker = plot_->markers[std::size_t(i)];
    if (marker.axis == MarkerAxis::Vertical && marker.draggable && isReceiver(i)) return i;
  }
  return std::nullopt;
}

std::optional<int> PlotPane::markerAt(int pixel) const {
  std::optional<int> found;
  double nearest = grabDistance;
  for (int i = 0; i < int(plot_->markers.size()); ++i) {
    const PlotMarker& marker = plot_->markers[std::size_t(i)];
    if (marker.axis != MarkerAxis::Vertical || !marker.draggable) continue;
    const double distance =
        std::abs(widget_->canvasMap(QwtPlot::xBottom).transform(marker.position) - pixel);
    if (distance > nearest) continue;
    nearest = distance;
    found = i;
  }
  return found;
}

void PlotPane::drag(int pixel) {
  // A plot set meanwhile may have fewer markers.
  if (*dragged_ >= int(plot_->markers.size())) return endDrag();
  if (isReceiver(*dragged_))
    emit depthDragged(depthAt(pixel));
  else
    emit markerDragged(*dragged_, depthAt(pixel));
}

void PlotPane::endDrag() {
  const int marker = *std::exchange(dragged_, std::nullopt);
  if (marker < int(plot_->markers.size()) && isReceiver(marker))
    emit depthDragFinished();
  else
    emit markerDragFinished();
}

double PlotPane::depthAt(int pixel) const {
  return std::clamp(widget_->invTransform(QwtPlot::xBottom, pixel), 0.0, 1.0);
}

void PlotPane::hover(const QPoint& pixel) {
  widget_->canvas()->setCursor(markerAt(pixel.x()) ? Qt::SplitHCursor : Qt::CrossCursor);
  const double x = widget_->invTransform(QwtPlot::xBottom, pixel.x());
  QToolTip::showText(widget_->canvas()->mapToGlobal(pixel + QPoint(8, 8)),
                     QString::fromStdString(readoutAt(*plot_, x)), widget_->canvas());
}

bool PlotPane::eventFilter(QObject* watched, QEvent* event) {
  if (!plot_) return Card::eventFilter(watched, event);
  if (watched == widget_->canvas()) return canvasEvent(event);
  if (watched == widget_->axisWidget(QwtPlot::xBottom)) return axisEvent(event);
  return Card::eventFilter(watched, event);
}

// The axis takes the receiver wherever it is pressed, the canvas only by its marker.
bool PlotPane::axisEvent(QEvent* event) {
  const QEvent::Type type = event->type();
  if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove &&
      type != QEvent::MouseButtonRelease)
    return false;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (type == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) dragged_ = receiver();
  if (!dragged_) return false;
  if (type == QEvent::MouseButtonRelease)
    endDrag();
  else
    drag(widget_->canvas()->mapFromGlobal(mouse->globalPos()).x());
  return true;
}

bool PlotPane::canvasEvent(QEvent* event) {
  if (event->type() == QEvent::Resize) fitAxisTitle();
  if (event->type() == QEvent::MouseMove) {
    const QPoint pixel = static_cast<QMouseEvent*>(event)->pos();
    if (dragged_)
      drag(pixel.x());
    else
      hover(pixel);
    return true;
  }
  if (event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton) return false;
    dragged_ = markerAt(mouse->pos().x());
    if (dragged_) QToolTip::hideText();
    return dragged_.has_value();
  }
  if (event->type() == QEvent::MouseButtonRelease && dragged_) {
    endDrag();
    return true;
  }
  return false;
}

void PlotPane::contextMenuEvent(QContextMenuEvent* event) {
  if (!plot_) return;
  QMenu menu(this);
  menu.addAction(tr("Copy picture"), this, &PlotPane::copy);
  menu.addAction(tr("Save as…"), this, &PlotPane::saveAs);
  menu.exec(event->globalPos());
}

}  // namespace umbra

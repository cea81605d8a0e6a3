#include "ui/errors/ErrorPane.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/errors/ErrorController.h"
#include "ui/errors/ErrorPicture.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/ElidedLabel.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/PictureCanvas.h"
#include "ui/widgets/tables/ErrorTable.h"

namespace umbra {
namespace {

constexpr int pictureBesideWidth =
    360;  // logical pixels from which table and picture stand side by side

// The part that contributes most to a pixel's error.
ErrorPart largestPart(const ErrorDecomposition& errors, const PicturePixel& pixel) {
  const auto parts = errors.parts.pixel(pixel.x, pixel.y);
  const auto largest = std::max_element(
      parts.begin(), parts.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return ErrorPart(largest - parts.begin());
}

}  // namespace

ErrorPane::ErrorPane(ErrorController& errors, Prober& prober, QWidget* parent)
    : Card(tr("Signed error"), parent),
      errors_(errors),
      prober_(prober),
      halves_(new QHBoxLayout),
      canvas_(new PictureCanvas),
      legend_(new ColourBar),
      table_(new ErrorTable),
      grid_(new ElidedLabel),
      readout_(new QLabel) {
  worst_ = addButton(tr("Go to the worst pixel"), "worstError",
                     tr("Pins the probe where the part that is shown is largest, inside the lasso "
                        "if there is one"));
  clear_ = addButton(tr("Clear"), "clearLasso", tr("Takes the lasso away (Escape)"));
  copy_ = addButton(tr("Copy"), "copyErrors", tr("Copies the table as text, tab separated"));
  auto* left = new QVBoxLayout;
  left->setSpacing(4);
  left->addWidget(canvas_, 1);
  left->addWidget(legend_);
  auto* right = new QVBoxLayout;
  right->setSpacing(4);
  right->addWidget(table_);
  right->addWidget(grid_);
  right->addWidget(readout_, 1);
  halves_->setSpacing(8);
  halves_->addLayout(left, 1);
  halves_->addLayout(right);
  body()->addLayout(halves_, 1);
  QPalette muted = grid_->palette();
  muted.setColor(QPalette::WindowText, style::muted);
  grid_->setPalette(muted);
  readout_->setObjectName("errorReadout");
  readout_->setPalette(muted);
  readout_->setWordWrap(true);
  readout_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // The text wraps in the table's width and asks for no height of its own, so that nothing moves
  // under the pointer.
  readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  readout_->setMinimumHeight(fontMetrics().height());
  grid_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);

  connect(worst_, &QToolButton::clicked, &errors_, &ErrorController::goToWorst);
  connect(clear_, &QToolButton::clicked, &errors_, &ErrorController::clearLasso);
  connect(copy_, &QToolButton::clicked, table_, &ErrorTable::copy);
  connect(table_, &ErrorTable::partChosen, &errors_, &ErrorController::setPart);
  connect(canvas_, &PictureCanvas::pixelClicked, &errors_, &ErrorController::pin);
  connect(canvas_, &PictureCanvas::lassoDrawn, this,
          [this](const QPolygonF& lasso) { errors_.setLasso(lasso, canvas_->picture().size()); });
  connect(canvas_, &PictureCanvas::pixelHovered, this, [this](int x, int y) {
    hovered_ = QPoint(x, y);
    showReadout();
  });
  connect(canvas_, &PictureCanvas::left, this, [this] {
    hovered_.reset();
    showReadout();
  });
  connect(&errors_, &ErrorController::changed, this, &ErrorPane::refresh);
  connect(&errors_, &ErrorController::progressed, this, &ErrorPane::refreshNote);
  connect(&prober_, &Prober::reported, this, &ErrorPane::refreshMark);
  refresh();
}

QToolButton* ErrorPane::addButton(const QString& text, const char* name, const QString& toolTip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(toolTip);
  button->setAutoRaise(true);
  addToHeader(button);
  return button;
}

void ErrorPane::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  halves_->setDirection(event->size().width() >= pictureBesideWidth ? QBoxLayout::LeftToRight
                                                                    : QBoxLayout::TopToBottom);
}

// Escape removes the lasso while there is one; without one it is left to the window.
bool ErrorPane::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && clear_->isEnabled())
    event->accept();
  return Card::event(event);
}

void ErrorPane::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !clear_->isEnabled()) return Card::keyPressEvent(event);
  errors_.clearLasso();
}

void ErrorPane::refresh() {
  refreshPicture();
  refreshFigures();
  refreshNote();
  refreshMark();
  showLegend();
  showReadout();
}

void ErrorPane::refreshPicture() {
  const auto taken = errors_.obstacle().isEmpty() ? errors_.taken() : nullptr;
  if (taken != painted_ || errors_.part() != paintedPart_) {
    painted_ = taken;
    paintedPart_ = errors_.part();
    range_ = taken ? colourRange(taken->errors, paintedPart_) : 1.0;
    canvas_->setPicture(
        taken ? errorPicture(taken->errors, paintedPart_, range_, taken->surfaces, taken->reference)
              : QImage());
  }
  canvas_->setFaded(taken && !errors_.current());
  canvas_->setLasso(taken ? errors_.lassoIn(canvas_->picture().size()) : QPolygonF());
}

void ErrorPane::refreshFigures() {
  const bool current = painted_ && errors_.current();
  setTitle(painted_ ? painted_->technique : tr("Signed error"));
  if (painted_)
    table_->setSums(painted_->technique, errors_.frameSums(), errors_.lassoSums());
  else
    table_->clearSums();
  table_->setFaded(!current);
  table_->setPart(errors_.part());
  const int stride = painted_ ? painted_->errors.stride : 1;
  grid_->setVisible(stride > 1);
  grid_->setText(tr("1 of %1 pixels: wide regions").arg(stride * stride));
  worst_->setEnabled(current);
  clear_->setEnabled(painted_ && errors_.lassoSums());
  copy_->setEnabled(current);
}

void ErrorPane::refreshNote() {
  const QString obstacle = errors_.obstacle();
  const QString work = errors_.working() ? tr("Taking the picture's error apart … %1 %")
                                               .arg(int(std::lround(100.0 * errors_.progress())))
                                         : tr("Waiting for the picture to rest …");
  canvas_->setHint(obstacle.isEmpty() ? work : obstacle);
  const bool old = painted_ && !errors_.current();
  canvas_->setNote(old ? tr("Of an earlier picture. %1").arg(work) : QString());
}

void ErrorPane::refreshMark() {
  const auto& report = prober_.report();
  if (!painted_ || !errors_.current() || !report || !report->point)
    return canvas_->setMark(std::nullopt);
  canvas_->setMark(QPointF(report->pixel.x + 0.5, report->pixel.y + 0.5));
}

void ErrorPane::showLegend() {
  legend_->setVisible(painted_ != nullptr);
  legend_->setScale(ColourMap::Diverging, -range_, range_, tr("too dark … too light"));
}

// Shows the figures of the pixel under the pointer, also after the picture beneath it has changed.
void ErrorPane::showReadout() {
  if (!painted_) return readout_->clear();
  if (!hovered_ || !canvas_->picture().rect().contains(*hovered_))
    return readout_->setText(
        tr("Drag over the picture to circle a part of it; click to probe a pixel; turn the wheel "
           "to look closer."));
  const ErrorDecomposition& errors = painted_->errors;
  const PicturePixel pixel = errors.takenPixel(hovered_->x(), hovered_->y());
  QString text = tr("no shadow falls here");
  if (errors.receives(pixel.x, pixel.y)) {
    const double error = errorAt(errors, pixel.x, pixel.y, std::nullopt);
    const QString whole = style::signedFigure(error);
    if (errors_.part())
      text =
          tr("%1 %2, of %3 in all")
              .arg(titleOf(errors_.part()).toLower(),
                   style::signedFigure(errorAt(errors, pixel.x, pixel.y, errors_.part())), whole);
    else if (error == 0.0)
      text = whole;
    else
      text = tr("%1, mostly %2").arg(whole, titleOf(largestPart(errors, pixel)).toLower());
  }
  readout_->setText(tr("Pixel %1, %2: %3").arg(pixel.x).arg(pixel.y).arg(text));
}

}  // namespace umbra

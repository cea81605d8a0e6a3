#include "ui/widgets/tables/TracePane.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "analysis/probe/Explain.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

enum TraceColumn { Symbol, Value, Formula, Meaning, TraceColumnCount };

}  // namespace

TracePane::TracePane(QWidget* parent)
    : Card({}, parent), sentence_(new QLabel), view_(new QTableWidget(0, TraceColumnCount)) {
  auto* copy = new QToolButton;
  copy->setText(tr("Copy"));
  copy->setAutoRaise(true);
  copy->setToolTip(tr("The sentence and all steps, as plain text"));
  connect(copy, &QToolButton::clicked, this, &TracePane::copy);
  addToHeader(copy);

  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // A label that wraps asks for the height of its narrowest shape.
  sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  body()->addWidget(sentence_);

  view_->setHorizontalHeaderLabels({tr("Step"), tr("Value"), tr("Formula"), tr("Meaning")});
  view_->horizontalHeaderItem(Value)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (int column : {Symbol, Formula, Meaning})
    view_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  view_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setHighlightSections(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setMinimumSectionSize(10);
  view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 2);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setShowGrid(false);
  view_->setWordWrap(false);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  body()->addWidget(view_, 1);
  // Without this a longer sentence would take height from the picture, and the probe would lose its
  // pixel.
  setMinimumHeight(140);
  clear();
}

void TracePane::setTrace(const QString& technique, const Trace& trace) {
  setTitle(tr("%1 at this pixel, step by step").arg(technique));
  sentence_->setText(QString::fromStdString(trace.sentence));
  QPalette palette = sentence_->palette();
  palette.setColor(QPalette::WindowText,
                   trace.cause == ErrorCause::None ? style::ink : style::error);
  sentence_->setPalette(palette);
  view_->setVisible(true);
  view_->setRowCount(int(trace.steps.size()));
  for (int row = 0; row < view_->rowCount(); ++row)
    setStep(row, trace.steps[row], trace.culprit == row);
  if (trace.culprit)
    view_->scrollToItem(view_->item(*trace.culprit, Symbol), QAbstractItemView::PositionAtCenter);
  text_ = technique + "\n" + QString::fromStdString(traceText(trace));
}

void TracePane::setStep(int row, const TraceStep& step, bool culprit) {
  const QString texts[] = {QString::fromStdString(step.symbol), style::figure(step.value),
                           QString::fromStdString(step.formula),
                           QString::fromStdString(step.meaning)};
  for (int column = 0; column < TraceColumnCount; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    if (column == Value) {
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFont(style::figures(font()));
      item->setToolTip(QString::number(step.value, 'g', 17));
    }
    if (culprit) {
      item->setForeground(style::error);
      item->setBackground(style::tint(style::error));
    }
    view_->setItem(row, column, item);
  }
}

void TracePane::clear(const QString& hint) {
  setTitle(tr("The technique, step by step"));
  QPalette palette = sentence_->palette();
  palette.setColor(QPalette::WindowText, style::muted);
  sentence_->setPalette(palette);
  sentence_->setText(
      hint.isEmpty() ? tr("Point at a shadow: every step of the technique's evaluation there, and "
                          "the one that goes wrong, appear here.")
                     : hint);
  view_->setRowCount(0);
  view_->setVisible(false);
  text_.clear();
}

QString TracePane::sentence() const {
  return sentence_->text();
}

void TracePane::copy() const {
  if (!text_.isEmpty()) QGuiApplication::clipboard()->setText(text_);
}

}  // namespace umbra

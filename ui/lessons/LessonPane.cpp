#include "ui/lessons/LessonPane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/lessons/LessonController.h"
#include "ui/lessons/LessonQuestionPane.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

QLabel* readingLabel() {
  auto* label = new QLabel;
  label->setTextFormat(Qt::MarkdownText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() + 0.5);
  label->setFont(font);
  return label;
}

}  // namespace

LessonPane::LessonPane(LessonController& lessons, QWidget* parent)
    : Card({}, parent),
      lessons_(lessons),
      step_(new QLabel),
      text_(readingLabel()),
      look_(readingLabel()),
      lookBox_(new QWidget),
      place_(new QLabel),
      question_(new LessonQuestionPane(lessons)),
      scroll_(new QScrollArea),
      back_(new QPushButton(tr("‹ &Back"))),
      next_(new QPushButton(tr("&Next ›"))) {
  auto* leave = new QToolButton;
  leave->setObjectName("leaveLesson");
  leave->setText(tr("Leave"));
  leave->setAutoRaise(true);
  leave->setToolTip(tr("Back to your own scene, as you left it"));
  addToHeader(leave);
  connect(leave, &QToolButton::clicked, this, &LessonPane::leaveRequested);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(makePage());
  body()->addWidget(scroll_, 1);
  body()->addWidget(makeNavigation());
  setMinimumWidth(240);
  connect(&lessons_, &LessonController::changed, this, &LessonPane::refresh);
  connect(&lessons_, &LessonController::measured, this, &LessonPane::refreshTexts);
  connect(question_, &LessonQuestionPane::answered, this, [this] {
    QMetaObject::invokeMethod(
        this, [this] { scroll_->ensureWidgetVisible(question_, 0, 0); }, Qt::QueuedConnection);
  });
}

QWidget* LessonPane::makePage() {
  QFont bold = step_->font();
  bold.setPointSizeF(bold.pointSizeF() + 2.5);
  bold.setWeight(QFont::DemiBold);
  step_->setFont(bold);
  step_->setWordWrap(true);
  step_->setTextFormat(Qt::PlainText);
  // A strip in the probe's colour says that the text beside it is about the marked point.
  auto* strip = new QFrame;
  strip->setFixedWidth(3);
  strip->setStyleSheet(QString("background: %1;").arg(style::probe.name()));
  auto* lookRow = new QHBoxLayout(lookBox_);
  lookRow->setContentsMargins(0, 0, 0, 0);
  lookRow->setSpacing(9);
  lookRow->addWidget(strip);
  lookRow->addWidget(look_, 1);
  auto* page = new QWidget;
  page->setObjectName("lessonPage");
  page->setStyleSheet("QWidget#lessonPage { background: white; }");
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(2, 2, 8, 6);
  layout->setSpacing(10);
  layout->addWidget(step_);
  layout->addWidget(text_);
  layout->addWidget(lookBox_);
  layout->addWidget(question_);
  layout->addStretch(1);
  return page;
}

QWidget* LessonPane::makeNavigation() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 4, 0, 0);
  back_->setObjectName("lessonBack");
  next_->setObjectName("lessonNext");
  back_->setToolTip(tr("The step before (Alt+Left)"));
  place_->setAlignment(Qt::AlignCenter);
  layout->addWidget(back_);
  layout->addWidget(place_, 1);
  layout->addWidget(next_);
  connect(back_, &QPushButton::clicked, &lessons_, &LessonController::back);
  connect(next_, &QPushButton::clicked, this, [this] {
    if (lessons_.progress() && lessons_.progress()->atLast())
      emit leaveRequested();
    else
      lessons_.next();
  });
  return row;
}

// Their numbers are those of the probe.
void LessonPane::refreshTexts() {
  const auto& progress = lessons_.progress();
  if (!progress) return;
  text_->setText(lessons_.filledIn(progress->current().text));
  look_->setText(tr("**Look at** ") + lessons_.filledIn(progress->current().look));
}

void LessonPane::refresh() {
  const auto& progress = lessons_.progress();
  if (!progress) return shown_.clear();
  const LessonStep& step = progress->current();
  setTitle(style::text(progress->lesson.title));
  step_->setText(style::text(step.title));
  refreshTexts();
  lookBox_->setVisible(!step.look.empty());
  place_->setText(tr("%1 of %2").arg(progress->step + 1).arg(progress->lesson.steps.size()));
  place_->setToolTip(
      progress->lesson.after.empty()
          ? QString()
          : style::plainTip(tr("After %1").arg(style::text(progress->lesson.after))));
  back_->setEnabled(!progress->atFirst());
  next_->setText(progress->atLast() ? tr("Fi&nish") : tr("&Next ›"));
  next_->setToolTip(progress->atLast() ? tr("Back to your own scene, as you left it")
                                       : tr("The next step (Alt+Right)"));
  question_->refresh();
  const QString now = QString("%1 %2").arg(style::text(progress->lesson.name)).arg(progress->step);
  if (now != shown_) {
    scroll_->verticalScrollBar()->setValue(0);
    // Digits are typed into the prediction; without the focus there they would choose techniques.
    if (progress->veiled()) question_->awaitPrediction();
  }
  shown_ = now;
}

}  // namespace umbra

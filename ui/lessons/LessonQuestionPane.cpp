#include "ui/lessons/LessonQuestionPane.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "ui/lessons/LessonController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int sliderSteps = 1000;

QLabel* wrapping(Qt::TextFormat format) {
  auto* label = new QLabel;
  label->setTextFormat(format);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QLabel* caption(const QString& text) {
  auto* label = new QLabel(text);
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, style::muted);
  label->setPalette(palette);
  return label;
}

QLabel* bigFigure() {
  auto* label = new QLabel;
  QFont font = style::figures(label->font());
  font.setPointSizeF(font.pointSizeF() + 4.0);
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

// Digits after the point that tell predictions apart over the range.
int decimalsFor(double range) {
  return std::clamp(3 - int(std::floor(std::log10(range) + 0.5)), 0, 6);
}

// "You said 0.40; it is 0.216 (reference 0). Within 0.02 counts as right."
QString verdictOf(const LessonQuestion& question, double predicted, double measured,
                  const std::optional<double>& reference) {
  const int decimals = decimalsFor(question.high - question.low);
  const auto figure = [&](double value) { return QString::number(value, 'f', decimals); };
  const bool right = std::abs(predicted - measured) <= question.tolerance;
  QString text = right ? LessonQuestionPane::tr("Right: you said %1, it is %2")
                       : LessonQuestionPane::tr("You said %1; it is %2");
  text = text.arg(figure(predicted), figure(measured));
  if (question.asked.quantity == Quantity::Visibility && reference)
    text += LessonQuestionPane::tr(" (reference %1)").arg(style::figure(*reference));
  return text + LessonQuestionPane::tr(". Within %1 counts as right.")
                    .arg(style::figure(question.tolerance));
}

}  // namespace

LessonQuestionPane::LessonQuestionPane(LessonController& lessons, QWidget* parent)
    : QFrame(parent),
      lessons_(lessons),
      text_(wrapping(Qt::MarkdownText)),
      slider_(new QSlider(Qt::Horizontal)),
      field_(new QDoubleSpinBox),
      button_(new QPushButton(tr("&Show what it is"))),
      predicted_(bigFigure()),
      measured_(bigFigure()),
      quantity_(caption({})),
      verdict_(wrapping(Qt::PlainText)),
      cause_(wrapping(Qt::PlainText)),
      explanation_(wrapping(Qt::MarkdownText)) {
  setObjectName("question");
  setStyleSheet(QString("QFrame#question { background: %1; border: 1px solid %2; "
                        "border-radius: 4px; }")
                    .arg(style::ground.name(), style::border.name()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 10);
  layout->setSpacing(8);
  layout->addWidget(text_);
  layout->addWidget(entry_ = makeEntry());
  layout->addWidget(answer_ = makeAnswer());
  connect(&lessons_, &LessonController::measured, this, &LessonQuestionPane::refreshText);
  connect(&lessons_, &LessonController::measured, this, &LessonQuestionPane::refreshAnswer);
}

QWidget* LessonQuestionPane::makeEntry() {
  auto* entry = new QWidget;
  auto* grid = new QGridLayout(entry);
  grid->setContentsMargins(0, 0, 0, 0);
  slider_->setRange(0, sliderSteps);
  slider_->setObjectName("predictionSlider");
  field_->setObjectName("predictionField");
  field_->setKeyboardTracking(true);
  field_->setSpecialValueText(QStringLiteral("?"));
  button_->setObjectName("predictionButton");
  grid->addWidget(caption(tr("I predict")), 0, 0, 1, 2);
  grid->addWidget(slider_, 1, 0);
  grid->addWidget(field_, 1, 1);
  grid->addWidget(button_, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  const auto take = [this] {
    const QSignalBlocker quiet(field_);
    field_->setValue(std::lerp(low_, high_, double(slider_->sliderPosition()) / sliderSteps));
    button_->setEnabled(true);
  };
  connect(slider_, &QSlider::valueChanged, this, take);
  // The slider stands at the lower end while nothing is predicted: to touch it there predicts that.
  connect(slider_, &QSlider::sliderPressed, this, take);
  connect(slider_, &QSlider::actionTriggered, this, take);
  connect(field_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(int(std::lround((value - low_) / (high_ - low_) * sliderSteps)));
    button_->setEnabled(value >= low_);
  });
  connect(button_, &QPushButton::clicked, this, &LessonQuestionPane::predict);
  for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* enter = new QShortcut(QKeySequence(key), entry);
    enter->setContext(Qt::WidgetWithChildrenShortcut);
    connect(enter, &QShortcut::activated, this, &LessonQuestionPane::predict);
  }
  return entry;
}

QWidget* LessonQuestionPane::makeAnswer() {
  auto* answer = new QWidget;
  auto* grid = new QGridLayout(answer);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(3);
  grid->addWidget(caption(tr("Prediction")), 0, 0);
  grid->addWidget(caption(tr("Measurement")), 0, 1);
  grid->addWidget(predicted_, 1, 0);
  grid->addWidget(measured_, 1, 1);
  grid->addWidget(quantity_, 2, 1);
  grid->addWidget(verdict_, 3, 0, 1, 2);
  grid->addWidget(caption(tr("What the technique made of it")), 4, 0, 1, 2);
  grid->addWidget(cause_, 5, 0, 1, 2);
  grid->addWidget(explanation_, 6, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return answer;
}

QString LessonQuestionPane::measuredText() const {
  return answer_->isHidden() ? QString() : measured_->text();
}

QString LessonQuestionPane::verdict() const {
  return answer_->isHidden() ? QString() : verdict_->text();
}

void LessonQuestionPane::refresh() {
  const auto& progress = lessons_.progress();
  setVisible(progress && progress->current().question);
  if (!progress || !progress->current().question) return;
  const LessonQuestion& question = *progress->current().question;
  refreshText();
  const double range = question.high - question.low;
  field_->setDecimals(decimalsFor(range));
  low_ = question.low;
  high_ = question.high;
  // Nothing is predicted yet: whatever stood there would be an answer.
  field_->setRange(low_ - range / 100.0, high_);
  field_->setSingleStep(range / 100.0);
  if (progress->veiled()) field_->setValue(field_->minimum());
  button_->setEnabled(field_->value() >= low_);
  entry_->setVisible(progress->veiled());
  answer_->setVisible(!progress->veiled());
  refreshAnswer();
}

void LessonQuestionPane::refreshText() {
  const auto& progress = lessons_.progress();
  if (!progress || !progress->current().question) return;
  text_->setText(tr("**Predict first.** ") + lessons_.filledIn(progress->current().question->text));
}

void LessonQuestionPane::refreshAnswer() {
  const auto& progress = lessons_.progress();
  if (!progress || !progress->current().question || progress->veiled()) return;
  const LessonQuestion& question = *progress->current().question;
  const double predicted = *progress->prediction();
  const int decimals = decimalsFor(question.high - question.low);
  const std::optional<double> measured = lessons_.measurement();
  const auto figure = [&](double value) { return QString::number(value, 'f', decimals); };
  predicted_->setText(figure(predicted));
  measured_->setText(measured ? figure(*measured) : QString(QChar(0x2013)));
  quantity_->setText(style::text(describe(question.asked)));
  const QString cause = lessons_.cause();
  cause_->setText(cause);
  cause_->setVisible(!cause.isEmpty());
  explanation_->setText(lessons_.filledIn(question.explanation));
  if (!measured) return verdict_->clear();
  verdict_->setText(verdictOf(question, predicted, *measured, lessons_.reference()));
}

void LessonQuestionPane::awaitPrediction() {
  field_->setFocus();
  field_->selectAll();
}

void LessonQuestionPane::predict() {
  if (!lessons_.progress() || !lessons_.progress()->veiled()) return;
  field_->interpretText();
  if (field_->value() < low_) return;  // there is no prediction yet
  lessons_.predict(field_->value());
  emit answered();
}

}  // namespace umbra

#include "ui/lessons/LessonController.h"

#include "analysis/errors/Measure.h"
#include "datasets/lessons/LessonNumbers.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

LessonController::LessonController(SessionController& session, Prober& prober, QObject* parent)
    : QObject(parent), session_(session), prober_(prober) {
  connect(&prober_, &Prober::reported, this, &LessonController::measured);
  connect(&session_, &SessionController::changed, this, &LessonController::refreshVeil);
  connect(&session_, &SessionController::loadingChanged, this, &LessonController::refreshVeil);
}

// A step's source may still be read beside this thread, or it could not be read. Its parameters do
// not count, since they may have been adjusted after it was opened.
bool LessonController::arrived() const {
  if (!progress_ || session_.loading()) return false;
  const SceneSource &open = session_.session().source, &asked = progress_->current().session.source;
  return open.kind == asked.kind && open.name == asked.name;
}

std::optional<double> LessonController::measurement() const {
  const auto& report = prober_.behindVeil();
  if (!arrived() || !progress_->current().question || !report) return std::nullopt;
  const LessonQuantity& asked = progress_->current().question->asked;
  return umbra::measured(report->probe, asked.quantity, asked.technique);
}

std::optional<double> LessonController::reference() const {
  const auto& report = prober_.behindVeil();
  if (!arrived() || !report) return std::nullopt;
  return report->probe.reference;
}

QString LessonController::filledIn(const std::string& text) const {
  const LessonStep& step = progress_->current();
  const auto& report = prober_.behindVeil();
  return style::text(filled(
      text, step, progress_->step, [&](const LessonQuantity& quantity) -> std::optional<double> {
        const bool tells = progress_->veiled() && (infoOf(quantity.quantity).ofTechnique ||
                                                   quantity == step.question->asked);
        if (!arrived() || !report || !report->pinned || tells) return std::nullopt;
        return umbra::measured(report->probe, quantity.quantity, quantity.technique);
      }));
}

QString LessonController::cause() const {
  const auto& report = prober_.behindVeil();
  if (!arrived() || !progress_->current().question || !report) return {};
  const LessonQuantity& asked = progress_->current().question->asked;
  if (!infoOf(asked.quantity).ofTechnique) return {};
  return QString::fromStdString(causeOf(report->probe, asked.technique));
}

void LessonController::enter(const Lesson& lesson) {
  progress_ = LessonProgress{lesson, 0, {}};
  show();
}

void LessonController::leave() {
  if (!progress_) return;
  progress_.reset();
  refreshVeil();
  session_.leave();
  emit changed();
}

void LessonController::next() {
  if (progress_ && !progress_->atLast()) goTo(progress_->step + 1);
}

void LessonController::back() {
  if (progress_ && !progress_->atFirst()) goTo(progress_->step - 1);
}

void LessonController::restart() {
  if (progress_) goTo(progress_->step);
}

void LessonController::predict(double value) {
  if (!progress_ || !progress_->veiled()) return;
  progress_->predicted[progress_->step] = value;
  refreshVeil();
  emit changed();
}

void LessonController::goTo(std::size_t step) {
  progress_->step = step;
  show();
}

// The veil is put on before the step's session is shown, so that no figure can be read meanwhile.
void LessonController::show() {
  refreshVeil();
  session_.visit(progress_->current().workspace);
  emit changed();
}

void LessonController::refreshVeil() {
  const bool veiled = progress_ && (progress_->veiled() || !arrived());
  prober_.setVeil(veiled ? tr("Predict first: the lesson asks what comes out here.") : QString());
}

}  // namespace umbra

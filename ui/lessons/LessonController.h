// Leads through a lesson: which step is shown, what was predicted. The window's own session waits
// in the session controller meanwhile.
#pragma once

#include <QObject>
#include <optional>

#include "ui/lessons/LessonProgress.h"

namespace umbra {

class Prober;
class SessionController;

class LessonController : public QObject {
  Q_OBJECT

 public:
  LessonController(SessionController& session, Prober& prober, QObject* parent = nullptr);

  // None while no lesson is read.
  const std::optional<LessonProgress>& progress() const { return progress_; }
  // The quantity that the step asks for, at the present probe; none while there is no probe.
  std::optional<double> measurement() const;
  // The reference at the present probe, none while there is no probe.
  std::optional<double> reference() const;
  // The text of the step with its numbers, as far as they are measured and may be told: before the
  // prediction only what describes the region.
  QString filledIn(const std::string& text) const;
  // Explains the measurement in one sentence; "" where nothing explains it.
  QString cause() const;

  void enter(const Lesson& lesson);
  void leave();  // the window's own session comes back
  void next();
  void back();
  // Shows the present step as at its beginning: whatever was changed in it is put back.
  void restart();
  void predict(double value);

 signals:
  void changed();   // progress() is another one, or gone
  void measured();  // measurement() and cause() are new

 private:
  void goTo(std::size_t step);
  void show();
  void refreshVeil();
  bool arrived() const;  // whether the step's own source is what is open

  SessionController& session_;
  Prober& prober_;
  std::optional<LessonProgress> progress_;
};

}  // namespace umbra

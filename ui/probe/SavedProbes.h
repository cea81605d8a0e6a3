// The probes that are saved, read in every frame that is at rest.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

#include "analysis/probe/ProbeSheet.h"
#include "ui/picture/ProbeMarks.h"
#include "ui/probe/HeldPoint.h"

namespace umbra {

class Prober;
class SceneView;
class SessionController;
struct Document;

// Reads one probe after the other, and lets the window answer between them: each costs what
// pointing at a place does.
class SavedProbes : public QObject {
  Q_OBJECT

 public:
  struct Row {
    NamedProbe probe;
    std::optional<SheetFigures> figures;  // of the settings before, until it is read again
    QString reason;                       // why there are no figures; empty before it is read
    bool hidden = false;                  // from the camera
  };

  SavedProbes(SessionController& controller, SceneView& view, Prober& prober,
              QObject* parent = nullptr);

  const std::vector<Row>& rows() const { return rows_; }
  // The one that the session's probe is at; −1 for none.
  int current() const;
  // Marks for the picture: all but the probe that the session's probe is at, which is drawn as the
  // probe.
  std::vector<ProbeMark> marks() const;
  // All are read with the present settings.
  bool upToDate() const { return next_ >= rows_.size() && !rest_.isActive(); }

  // Whether there is a pinned or hovered place to save, which is none of the saved ones, or one of
  // them with another receiver.
  bool canSave() const;
  // All are a step for undo.
  void save();  // the present probe; pins it
  void rename(int row, const QString& name);
  void drop(int row);
  void goTo(int row);

  // With `separator` between fields, see sheetText; all techniques in their order.
  QString text(char separator) const;

 signals:
  void changed();
  void message(const QString& text);

 private:
  void sessionChanged(const Document& before, const Document& after);
  void start();
  void readNext();
  void read(std::size_t row);
  QString wishedName() const;

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  std::vector<Row> rows_;
  std::vector<std::optional<HeldPoint>> held_;  // by row; none on a depth file
  QTimer rest_;                                 // the picture stands still since
  std::size_t next_ = 0;                        // to be read
};

}  // namespace umbra

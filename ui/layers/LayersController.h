// The layers of the session's technique, and the instrument that places their splits: the map's
// second occluders, splits dragged by hand, and Lloyd's relaxation step by step.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "analysis/plots/LloydRun.h"
#include "analysis/probe/Probe.h"
#include "filters/techniques/lvsm/Layers.h"
#include "ui/session/Document.h"

namespace umbra {

class SceneView;
class SessionController;

// The splits themselves belong to the session: a change of them is an edit of the session, and is
// undone with it. What is kept here follows from the map.
class LayersController : public QObject {
  Q_OBJECT

 public:
  // The map's second occluders (Lauritzen 2008, §4.1.3).
  struct Occluders {
    std::shared_ptr<const SortedSamples> samples;
    Histogram histogram;  // of their depths by weight; empty where none has any
  };

  LayersController(SessionController& controller, SceneView& view, QObject* parent = nullptr);
  ~LayersController() override;

  // Second occluders are looked for only while somebody looks at them.
  void setWatched(bool watched);

  bool layered() const;  // the session's technique
  // The layers in use, as the picture has them; none for a technique without layers.
  std::optional<Layering> layering() const;
  // The second occluders of the present map, which are looked for beside the interface's thread;
  // null before they are found.
  const Occluders* occluders() const { return occluders_ ? &*occluders_ : nullptr; }
  // The iterations that were shown since the splits were last placed in another way, and which of
  // them is in use. Null where there is nothing to relax.
  const LloydRun* run() const { return run_ ? &*run_ : nullptr; }
  std::size_t shown() const { return shown_; }
  std::size_t reached() const { return reached_; }
  double uniformCost() const { return uniformCost_; }
  bool canStep() const { return canStep_; }
  bool playing() const { return play_.isActive(); }

  // A drag is one step for undo; a split stays between its neighbours.
  void dragSplit(int split, double depth);
  void endDrag();

 public slots:
  void startUniform();
  void step();
  void setPlaying(bool playing);
  void toEnd();

 signals:
  void changed();
  void failed(const QString& message);

 private:
  void sessionChanged(const Document& before, const Document& after);
  void refresh();
  void lookForOccluders();
  void found(const Occluders& occluders);
  std::shared_ptr<const void> presentMap() const;
  std::vector<double> splits() const;
  void followSplits();
  void relaxDepthFile();
  bool goOn(const QString& mergeKey);
  void place(const QString& text, std::vector<double> splits, const QString& mergeKey);

  SessionController& controller_;
  SceneView& view_;
  bool watched_ = false, searching_ = false, placing_ = false, canStep_ = false;
  // The map whose occluders are there, and are being looked for; only to be compared.
  std::shared_ptr<const void> known_, asked_;
  std::optional<Occluders> occluders_;
  std::optional<LloydRun> run_;
  std::size_t shown_ = 0, reached_ = 0;
  std::vector<double> shownSplits_;
  std::vector<double> relaxed_;  // of a depth file, where its splits are to follow it
  double uniformCost_ = 0.0;
  QTimer still_;  // the map has not changed since
  QTimer play_;
  std::jthread thread_;
};

}  // namespace umbra

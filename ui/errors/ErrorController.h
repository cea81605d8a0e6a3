// The error of the window's frame, taken apart by its causes beside the interface's thread whenever
// frame and session are at rest.
#pragma once

#include <QObject>
#include <QPolygonF>
#include <QSize>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "analysis/errors/ErrorDecomposition.h"
#include "datasets/session/Session.h"
#include "filters/core/frame/FrameSnapshot.h"

namespace umbra {

class Prober;
class SceneView;
class SessionController;

class ErrorController : public QObject {
  Q_OBJECT

 public:
  struct Taken {
    QString technique;      // its title
    SurfaceImage surfaces;  // of the frame
    Image<float> reference;
    ErrorDecomposition errors;
  };

  ErrorController(SessionController& controller, SceneView& view, Prober& prober,
                  QObject* parent = nullptr);
  // Waits for the rows that are being taken.
  ~ErrorController() override;

  // While nobody looks (false), nothing is computed.
  void setWatched(bool watched);

  // Says why there can be no figures at all; "" where there can.
  QString obstacle() const;
  // What was taken apart last: of an earlier frame while the frame changes, null before the first
  // one.
  const std::shared_ptr<const Taken>& taken() const { return taken_; }
  bool current() const;  // taken() is of the present frame
  bool working() const { return working_; }
  double progress() const { return done_ ? done_->load() : 0.0; }  // of the work, 0 … 1

  std::optional<ErrorPart> part() const { return part_; }  // none: the whole error
  void setPart(std::optional<ErrorPart> part);
  // In pixels of a picture of `size`: a lasso stays where it is in the view while the picture's
  // size changes.
  QPolygonF lassoIn(const QSize& size) const;
  void setLasso(const QPolygonF& lasso, const QSize& size);
  void clearLasso() { setLasso({}, {}); }

  // The sums over taken(), which must not be null.
  const ErrorSums& frameSums() const { return frameSums_; }
  const std::optional<ErrorSums>& lassoSums() const { return lassoSums_; }  // none without a lasso

  // Both pin the probe, but only where current() holds.
  void pin(int x, int y);
  void goToWorst();  // of the part that is shown, inside the lasso if there is one

 signals:
  void changed();
  void progressed();
  void failed(const QString& message);

 private:
  // Frames with equal keys have equal errors.
  struct FrameKey {
    std::shared_ptr<const void> channels;  // Baked::channels
    Camera camera;
    QSize size;
    FrameSettings settings;

    bool operator==(const FrameKey&) const = default;
  };

  void refresh();
  std::optional<FrameKey> presentKey() const;
  void start();
  void computeBeside(const std::shared_ptr<const FrameSnapshot>& frame);
  void stop();
  void finished(int number, const std::shared_ptr<const Taken>& taken, const FrameKey& key);
  void gaveUp(int number, const QString& message);
  void sumUp();
  void outlineInView();

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  bool watched_ = false, working_ = false;
  QString shownObstacle_;
  std::shared_ptr<const Taken> taken_;
  FrameKey takenKey_, workKey_;
  std::optional<ErrorPart> part_;
  QPolygonF lasso_;
  QSize lassoSize_;  // of the picture that lasso_ was drawn in
  ErrorSums frameSums_;
  std::optional<ErrorSums> lassoSums_;
  QTimer still_;   // nothing has changed since
  QTimer tick_;    // tells of progress
  int asked_ = 0;  // number of the work that is wanted
  std::shared_ptr<std::atomic<double>> done_;
  std::jthread thread_;
};

}  // namespace umbra

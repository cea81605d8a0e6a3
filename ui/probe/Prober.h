// Takes the probed region apart whenever the probe, the map or a parameter changed.
#pragma once

#include <QObject>
#include <QSize>
#include <optional>

#include "datasets/session/LoadSource.h"
#include "ui/picture/ProbeReport.h"
#include "ui/probe/HeldPoint.h"
#include "ui/probe/ProbeTaker.h"

namespace umbra {

class SceneView;
class SessionController;
struct Document;

// Follows the pointer over the picture until a click pins the probe to a point of the surface; a
// pinned one stays on its point while camera, light and parameters change, in sight or not. On a
// depth file the texel is the probe and the session's receiver the depth.
class Prober : public QObject {
  Q_OBJECT

 public:
  Prober(SessionController& controller, SceneView& view, QObject* parent = nullptr);

  // None while a veil lies over it.
  const std::optional<ProbeReport>& report() const { return veil_.isEmpty() ? report_ : hidden_; }
  // The probe itself, for what shows no figures of it.
  const std::optional<ProbeReport>& behindVeil() const { return report_; }
  // Hides the probe's figures from every pane; `reason` is what they say instead, "" lifts it.
  void setVeil(const QString& reason);
  const QString& veil() const { return veil_; }

  void hover(const Pixel& pixel);  // of the picture, or a texel
  void pin(const Pixel& pixel);    // a step for undo
  void unpin();
  // Probes where the probe is: once for each frame, place and setting, however often it is asked.
  void refresh();
  // World; where the pinned probe is held. Given back, it is held there again, whatever size the
  // picture has by then.
  std::optional<Eigen::Vector3d> pinnedPoint() const;
  void holdPoint(const std::optional<Eigen::Vector3d>& point);
  // Pins the pixel of the last frame where light bleeds most, a step for undo; none where no light
  // bleeds.
  void pinWorstBleeding();
  void startAtWorstBleeding();  // the same, but no step: nobody has done anything yet
  // Within an edit: the probe is at this pixel of the present picture, or this texel, and at none
  // that is saved.
  void place(Session& session, const Pixel& at) const;
  // Gives the session the pixel that shows the pinned point now, so that undo finds it again:
  // before the probe goes elsewhere.
  void settlePixel();

  // For other probes of the same frame.
  ProbeTaker& taker() { return taker_; }

 signals:
  void reported();  // report() is new, or gone
  void failed(const QString& message);

 private:
  // What a probe depends on. Two frames of one bake, seen alike, give the same probe.
  struct Question {
    Content content;
    FrameSettings frame;
    std::string technique;
    std::vector<std::shared_ptr<const Technique>> techniques;
    std::optional<Pixel> pinned, hovered;
    std::optional<Eigen::Vector3d> held;
    std::string saved;
    std::optional<double> receiver;
    bool drawn = false;  // whether there is a frame; it was drawn from here
    Baked baked;
    Camera camera;
    QSize pixels;

    bool operator==(const Question&) const = default;
  };

  void showAgain();
  Question question() const;
  std::optional<Pixel> findWorstBleeding();
  std::optional<ProbeReport> take();
  std::optional<SurfacePlace> currentPlace();
  const NamedProbe* savedProbe() const;
  void sessionChanged(const Document& before, const Document& after);

  SessionController& controller_;
  SceneView& view_;
  std::optional<ProbeReport> report_, hidden_;  // hidden_ is always empty
  QString veil_;
  std::optional<Pixel> hover_;
  std::optional<HeldPoint> held_;     // once the frame has told it; of a hover the last place
  std::optional<Question> answered_;  // by report_
  ProbeTaker taker_;
};

}  // namespace umbra

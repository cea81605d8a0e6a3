// Takes the probed region apart whenever the probe, the map or a parameter changed.
#pragma once

#include <QObject>
#include <optional>

#include "filters/gpu/ShadowRenderer.h"
#include "ui/Footprint.h"
#include "ui/ProbeReport.h"

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
  // Probes again where the probe is: after a frame, or a change.
  void refresh();
  // World; where the pinned probe is held. Given back, it is held there again, whatever size the
  // picture has by then.
  const std::optional<Eigen::Vector3d>& pinnedPoint() const { return pinnedPoint_; }
  void holdPoint(const std::optional<Eigen::Vector3d>& point) { pinnedPoint_ = point; }
  // Pins the pixel of the last frame where light bleeds most; none where no light bleeds.
  void pinWorstBleeding();

 signals:
  void reported();  // report() is new, or gone
  void failed(const QString& message);

 private:
  // A point of a surface, as the frame showed it.
  struct Place {
    Pixel pixel;
    SurfacePoint surface;
    std::optional<Plane> plane;  // around it
    double depth = 0.0;          // in the light's frame, without bias
    int map = 0;                 // the revision of the map that it was read in
    bool inSight = true;
    ReadFilter filter = ReadFilter::Point;  // that the footprint is of
  };

  std::optional<ProbeReport> take();
  std::optional<ProbeReport> takeOnScene();
  std::optional<ProbeReport> takeOnDepthFile();
  std::optional<Place> visiblePlace();
  std::optional<Place> hiddenPlace();
  ProbeReport probeAt(const Place& place);
  void adaptTechniques(const DepthMap& map, int revision);
  ProbeRequest requestOn(const DepthMap& map, const ReadPoint& read, double receiver) const;
  // `first` is the map of the first cascade, to which techniques are adapted.
  ProbeReport probe(ProbeRequest request, const DepthMap& first, int revision);
  std::optional<Pixel> pinnedPixel();
  void sessionChanged(const Document& before, const Document& after);

  SessionController& controller_;
  SceneView& view_;
  std::optional<ProbeReport> report_, hidden_;  // hidden_ is always empty
  QString veil_;
  std::optional<Pixel> hover_;
  std::optional<Eigen::Vector3d> pinnedPoint_;             // world, once the frame has told it
  std::optional<Place> lastSeen_;                          // where the probe was last in sight
  std::vector<std::shared_ptr<const Technique>> adapted_;  // to the map of `adaptedTo_`
  int adaptedTo_ = -1;
  std::vector<double> splits_;  // that the picture's technique has in adapted_
};

}  // namespace umbra

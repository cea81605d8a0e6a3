// The picture: a VTK scene with filtered shadows, the camera, the light's handle and the probe.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QTimer>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "filters/gpu/ShadowRenderer.h"
#include "ui/picture/Footprint.h"
#include "ui/picture/ProbeReport.h"
#include "ui/picture/SceneOverlay.h"
#include "ui/session/Document.h"

namespace umbra {

// Pixels are device pixels of the picture, from its top-left corner. Frames are drawn when Qt
// paints: any number of changes before that cost one frame.
class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  // Shows a document that has a scene. `technique` is its technique.
  void showDocument(const Document& document, const Technique& technique);
  // The probe to draw over the picture, with the two lines beside it.
  void setReport(const std::optional<ProbeReport>& report, const QString& heading,
                 const QString& verdict, bool wrong);
  void setHint(const QString& hint);
  void setMarks(std::vector<ProbeMark> marks);  // of the saved probes
  // Another picture over the part of this one to the right of `at` of its width (0 … 1), or to the
  // left of it; `instead` is said there where there is none. Both empty show this one alone.
  void setCurtain(const QImage& picture, double at, const QString& instead, bool left);
  // Outlines a part of the picture; empty for none.
  void setSelection(const QPolygonF& pixels);
  void setFramed(bool framed);  // as the active one of several panes
  const SceneOverlay::Contents& overlayContents() const { return contents_; }

  QSize pixels() const;                                // of the picture
  Camera camera() const { return shadow_->camera(); }  // as the mouse may have moved it
  Pixel pixelAt(const QPointF& point) const;
  // Where a world point is seen, hidden or not.
  std::optional<Pixel> pixelOf(const Eigen::Vector3d& world) const;

  const LightHandle& lightHandle() const { return overlay_->handle(); }

  // The renderer of the last frame; null before the first one, and where the last one could not be
  // drawn.
  ShadowRenderer* lastFrame() { return drawn_ ? shadow_.get() : nullptr; }
  const ShadowRenderer* lastFrame() const { return drawn_ ? shadow_.get() : nullptr; }
  std::optional<SurfacePoint> surfaceAt(const Pixel& pixel);
  // Surfaces and reference of the frame as another technique would shade it; the picture stays.
  // Throws as ShadowRenderer::render does.
  std::pair<SurfaceImage, Image<float>> measure(const Technique& technique);
  // The surface around a pixel, as a plane.
  std::optional<Plane> surfacePlane(const Pixel& pixel, const SurfacePoint& centre);
  Baked baked() const { return shadow_->baked(); }  // of the last frame
  // What was asked for last is not drawn yet: a frame will follow, if it can be drawn.
  bool stale() const { return stale_; }
  // Whether the last frame shows all that was asked for, with splits at rest.
  bool upToDate() const { return drawn_ && !stale_ && !shadow_->splitsMoving(); }

 signals:
  void frameDrawn();
  void hovered(const umbra::Pixel& pixel);
  void clicked(const umbra::Pixel& pixel);
  void cameraMoved(const umbra::Camera& camera);  // when it comes to rest
  void lightDragged(const umbra::Light& light);   // while it moves
  void lightDragFinished();
  void failed(const QString& message);

 protected:
  bool event(QEvent* event) override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void prepareInteraction();
  void drawFrame();
  void finishFrame();
  void refreshOverlay();
  bool mouseEvent(QMouseEvent* event);
  bool dragLight(QMouseEvent* event);

  std::unique_ptr<ShadowRenderer> shadow_;
  SceneOverlay* overlay_;
  SceneOverlay::Contents contents_;
  Document shown_;
  QTimer hoverTimer_;
  QPointF pointer_;  // logical pixels
  std::optional<QPointF> pressed_, lightGrip_;
  const Scene* drawnScene_ = nullptr;  // by the last frame; only to be compared
  bool stale_ = true, drawn_ = false, painting_ = false;
  std::unique_ptr<Technique> technique_;
};

}  // namespace umbra

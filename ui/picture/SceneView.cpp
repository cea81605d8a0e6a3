#include "ui/picture/SceneView.h"

#include <QMouseEvent>
#include <cmath>
#include <exception>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "filters/core/technique/TechniqueEquality.h"

namespace umbra {
namespace {

constexpr int hoverInterval = 16;      // milliseconds: a probe per displayed frame at most
constexpr double clickDistance = 4.0;  // logical pixels that a click may wander

bool differ(const Camera& a, const Camera& b) {
  const double scale = 1e-9 * (1.0 + a.position.norm());
  return (a.position - b.position).norm() > scale || (a.target - b.target).norm() > scale ||
         (a.up - b.up).norm() > 1e-9 || std::abs(a.viewAngle - b.viewAngle) > 1e-9;
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {
  const vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);  // unasked, it would be 8 and cost three times the frame
  setRenderWindow(window);
  shadow_ = std::make_unique<ShadowRenderer>(*renderWindow());
  shadow_->setSplitPace(SplitPace::Gradual);
  overlay_ = new SceneOverlay(this);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  prepareInteraction();
  hoverTimer_.setSingleShot(true);
  hoverTimer_.setInterval(hoverInterval);
  connect(&hoverTimer_, &QTimer::timeout, this, [this] { emit hovered(pixelAt(pointer_)); });
}

SceneView::~SceneView() {
  makeCurrent();  // the renderer's textures belong to this context
  shadow_.reset();
  doneCurrent();
}

void SceneView::prepareInteraction() {
  vtkRenderWindowInteractor* interactor = renderWindow()->GetInteractor();
  const vtkNew<vtkInteractorStyleTrackballCamera> style;
  style->SetDefaultRenderer(&shadow_->renderer());
  interactor->SetInteractorStyle(style);
  // VTK then asks for frames by an event alone, and they are drawn when Qt paints.
  interactor->EnableRenderOff();
  const auto observe = [this](vtkObject* subject, unsigned long id, auto* function) {
    const vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(function);
    subject->AddObserver(id, command);
  };
  observe(
      interactor, vtkCommand::RenderEvent, +[](vtkObject*, unsigned long, void* view, void*) {
        auto* self = static_cast<SceneView*>(view);
        self->stale_ = true;
        if (!self->painting_) self->update();
      });
  observe(
      style, vtkCommand::EndInteractionEvent, +[](vtkObject*, unsigned long, void* view, void*) {
        auto* self = static_cast<SceneView*>(view);
        const Camera now = self->shadow_->camera();
        const Scene* scene = self->shown_.content.scene.get();
        if (scene && differ(now, self->shown_.session.camera.value_or(scene->camera)))
          emit self->cameraMoved(now);
      });
}

void SceneView::showDocument(const Document& document, const Technique& technique) {
  const std::shared_ptr<const Scene> scene = document.content.scene;
  if (!scene) return;
  const Session& session = document.session;
  const bool newScene = scene != shown_.content.scene;
  const auto lightOf = [](const Document& d) {
    return d.session.light.value_or(d.content.scene->light);
  };
  const bool newLight = newScene || !(lightOf(document) == lightOf(shown_));
  const bool newTechnique = !technique_ || !sameSettings(technique, *technique_);

  if (isValid()) makeCurrent();
  const Camera camera = session.camera.value_or(scene->camera);
  if (newScene) shadow_->setScene(scene);
  if (newLight) shadow_->setLight(lightOf(document));
  const bool newCamera = newScene || differ(camera, shadow_->camera());
  if (newCamera) shadow_->setCamera(camera);
  shadow_->setFrame(session.frame);
  if (newTechnique) {
    shadow_->setTechnique(technique);
    technique_ = technique.clone();
  }
  // What the picture does not show, such as the probe, costs no frame.
  stale_ =
      stale_ || newLight || newTechnique || newCamera || !(session.frame == shown_.session.frame);
  shown_ = document;
  contents_.light = lightOf(document);
  refreshOverlay();
  if (stale_) update();
}

void SceneView::setReport(const std::optional<ProbeReport>& report, const QString& heading,
                          const QString& verdict, bool wrong) {
  contents_.report = report;
  contents_.heading = heading;
  contents_.verdict = verdict;
  contents_.wrong = wrong;
  refreshOverlay();
}

void SceneView::setHint(const QString& hint) {
  contents_.hint = hint;
  refreshOverlay();
}

void SceneView::setMarks(std::vector<ProbeMark> marks) {
  contents_.marks = std::move(marks);
  refreshOverlay();
}

void SceneView::setCurtain(const QImage& picture, double at, const QString& instead, bool left) {
  contents_.curtain = picture;
  contents_.curtainLeft = left;
  contents_.curtainAt = at;
  contents_.curtainText = instead;
  refreshOverlay();
}

void SceneView::setSelection(const QPolygonF& pixels) {
  QPolygonF selection;
  for (const QPointF& point : pixels) selection << point / devicePixelRatioF();
  if (selection == contents_.selection) return;
  contents_.selection = selection;
  refreshOverlay();
}

void SceneView::setFramed(bool framed) {
  contents_.framed = framed;
  refreshOverlay();
}

QSize SceneView::pixels() const {
  const double ratio = devicePixelRatioF();
  return {int(std::lround(width() * ratio)), int(std::lround(height() * ratio))};
}

Pixel SceneView::pixelAt(const QPointF& point) const {
  const double ratio = devicePixelRatioF();
  return {int(std::floor(point.x() * ratio)), int(std::floor(point.y() * ratio))};
}

std::optional<Pixel> SceneView::pixelOf(const Eigen::Vector3d& world) const {
  const auto point = SceneProjection(shadow_->renderer(), size()).toWidget(world);
  if (!point || !QRectF(rect()).contains(*point)) return std::nullopt;
  return pixelAt(*point);
}

std::optional<SurfacePoint> SceneView::surfaceAt(const Pixel& pixel) {
  const QSize size = pixels();
  if (!drawn_ || pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width() || pixel.y >= size.height())
    return std::nullopt;
  makeCurrent();
  return shadow_->surfaceAt(pixel.x, pixel.y);
}

std::pair<SurfaceImage, Image<float>> SceneView::measure(const Technique& technique) {
  makeCurrent();
  const auto readBack = [this] { return std::pair(shadow_->surfaces(), shadow_->reference()); };
  if (upToDate() && sameSettings(technique, *technique_)) return readBack();
  // Whatever happens, the next frame is drawn with the session's technique again.
  const auto restore = [this] {
    shadow_->setSplitPace(SplitPace::Gradual);
    shadow_->setTechnique(*technique_);
    stale_ = true;
    update();
  };
  try {
    shadow_->setTechnique(technique);
    shadow_->render();
    if (shadow_->splitsMoving()) {
      shadow_->setSplitPace(SplitPace::Converged);
      shadow_->render();
    }
    auto measured = readBack();
    restore();
    return measured;
  } catch (...) {
    restore();
    throw;
  }
}

std::optional<Plane> SceneView::surfacePlane(const Pixel& pixel, const SurfacePoint& centre) {
  constexpr int step = 3;  // pixels: near enough to be one surface, far enough for float depths
  const auto worldAt = [&](int dx, int dy) -> std::optional<Eigen::Vector3d> {
    const auto surface = surfaceAt({pixel.x + dx, pixel.y + dy});
    if (!surface) return std::nullopt;
    return surface->world;
  };
  return planeThrough(centre.world, {worldAt(-step, 0), worldAt(step, 0)},
                      {worldAt(0, -step), worldAt(0, step)});
}

void SceneView::paintGL() {
  painting_ = true;
  if (stale_) drawFrame();
  stale_ = false;
  QVTKOpenGLNativeWidget::paintGL();  // may ask for a frame itself, as after a change of size
  if (stale_) {
    drawFrame();
    stale_ = false;
    QVTKOpenGLNativeWidget::paintGL();
  }
  painting_ = false;
}

void SceneView::drawFrame() {
  if (!shown_.content.scene) return;
  try {
    shadow_->render();
    drawn_ = true;
    drawnScene_ = shown_.content.scene.get();
    // What listens may read back and change widgets: not while Qt paints.
    QMetaObject::invokeMethod(this, &SceneView::finishFrame, Qt::QueuedConnection);
  } catch (const std::exception& problem) {
    drawn_ = false;
    const QString message = QString::fromUtf8(problem.what());
    QMetaObject::invokeMethod(
        this, [this, message] { emit failed(message); }, Qt::QueuedConnection);
  }
}

void SceneView::finishFrame() {
  // Another scene was asked for meanwhile: its probe is not to be looked for in this frame.
  if (drawnScene_ != shown_.content.scene.get()) return;
  refreshOverlay();
  emit frameDrawn();
  if (!drawn_ || !shadow_->splitsMoving()) return;
  stale_ = true;  // splits go on in the next frame
  update();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  overlay_->setGeometry(rect());
  stale_ = true;
  refreshOverlay();
}

void SceneView::refreshOverlay() {
  if (!shown_.content.scene) return;
  contents_.projection = SceneProjection(shadow_->renderer(), size());
  overlay_->setContents(contents_);
}

bool SceneView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::MouseButtonDblClick:
      if (mouseEvent(static_cast<QMouseEvent*>(event))) return true;
      break;
    case QEvent::Leave:
      hoverTimer_.stop();
      overlay_->setHandleHot(false);
      break;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      // VTK's own keys (w: wireframe, e: exit …) are none of this window's.
      return QOpenGLWidget::event(event);
    default:
      break;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

// True where the event is used up; VTK's interactor has the rest.
bool SceneView::mouseEvent(QMouseEvent* event) {
  const QPointF point = event->localPos();
  pointer_ = point;
  if (dragLight(event)) return true;
  if (event->type() == QEvent::MouseButtonPress && event->button() == Qt::LeftButton)
    pressed_ = point;
  if (event->type() == QEvent::MouseMove && event->buttons() == Qt::NoButton) {
    overlay_->setHandleHot(overlay_->handle().isAt(point));
    if (!hoverTimer_.isActive()) hoverTimer_.start();
  }
  if (event->type() == QEvent::MouseButtonRelease && event->button() == Qt::LeftButton &&
      pressed_) {
    const QPointF way = point - *pressed_;
    pressed_.reset();
    if (std::hypot(way.x(), way.y()) <= clickDistance)
      QMetaObject::invokeMethod(
          this, [this, pixel = pixelAt(point)] { emit clicked(pixel); }, Qt::QueuedConnection);
  }
  return false;
}

bool SceneView::dragLight(QMouseEvent* event) {
  const QPointF point = event->localPos();
  if (event->type() == QEvent::MouseButtonPress && event->button() == Qt::LeftButton &&
      overlay_->handle().isAt(point)) {
    lightGrip_ = point;
    return true;
  }
  if (!lightGrip_) return false;
  if (event->type() == QEvent::MouseMove) {
    const QPointF by = point - *lightGrip_;
    lightGrip_ = point;
    emit lightDragged(overlay_->handle().dragged(contents_.light, by, contents_.projection));
  } else if (event->type() == QEvent::MouseButtonRelease) {
    lightGrip_.reset();
    emit lightDragFinished();
  }
  return true;
}

}  // namespace umbra

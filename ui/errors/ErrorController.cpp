#include "ui/errors/ErrorController.h"

#include <QMetaObject>
#include <exception>
#include <utility>
#include <vector>

#include "analysis/errors/FrameDecomposition.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int sceneStillFor = 250;  // ms: a light or camera in the hand draws a frame after another
constexpr int tickInterval = 100;   // ms
// So many taps are read for one picture at most, which takes some five seconds on one core. A 7 × 7
// kernel needs far fewer.
constexpr double mostTaps = 3e7;

Image<std::uint8_t> maskOf(const QPolygonF& lasso, int width, int height) {
  std::vector<LassoPoint> points;
  for (const QPointF& point : lasso) points.push_back({point.x(), point.y()});
  return lassoMask(points, width, height);
}

// Whatever `progress` throws stops the work. The reference is not asked of the GPU: over wide
// regions a slow one takes seconds, in which nothing would move.
std::shared_ptr<const ErrorController::Taken> takenApart(
    const FrameSnapshot& frame, const std::function<void(double)>& progress) {
  const DecompositionSettings how;
  const int stride =
      decompositionStride(frame, *frame.technique, how, mostTaps, [&] { progress(0.0); });
  constexpr double first = 0.25;  // of the time, for the reference
  const Image<float> reference =
      referenceOf(frame, stride, [&](double part) { progress(first * part); });
  return std::make_shared<const ErrorController::Taken>(ErrorController::Taken{
      style::text(frame.technique->info().title), frame.surfaces, reference,
      decomposeFrame(frame, reference, frame.technique, how, stride,
                     [&](double part) { progress(first + (1.0 - first) * part); })});
}

}  // namespace

ErrorController::ErrorController(SessionController& controller, SceneView& view, Prober& prober,
                                 QObject* parent)
    : QObject(parent), controller_(controller), view_(view), prober_(prober) {
  still_.setSingleShot(true);
  still_.setInterval(sceneStillFor);
  tick_.setInterval(tickInterval);
  connect(&still_, &QTimer::timeout, this, &ErrorController::start);
  connect(&tick_, &QTimer::timeout, this, &ErrorController::progressed);
  connect(&controller_, &SessionController::changed, this,
          [this](const Document& before, const Document& after) {
            if (!(before.content == after.content)) {
              taken_.reset();
              lasso_.clear();
            }
            refresh();
          });
  connect(&view_, &SceneView::frameDrawn, this, &ErrorController::refresh);
  connect(&view_, &SceneView::failed, this, &ErrorController::refresh);
  connect(&prober_, &Prober::reported, this, [this] {
    if (obstacle() != shownObstacle_) refresh();  // a veil came or went
  });
}

ErrorController::~ErrorController() = default;

void ErrorController::setWatched(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  if (watched) return refresh();
  still_.stop();
  stop();
  outlineInView();
}

QString ErrorController::obstacle() const {
  if (!prober_.veil().isEmpty()) return prober_.veil();
  if (controller_.document().content.depth)
    return tr(
        "A depth map has no picture. Open a scene: the error of its picture is taken apart here.");
  return controller_.refusals().value(style::text(controller_.session().technique));
}

std::optional<ErrorController::FrameKey> ErrorController::presentKey() const {
  const ShadowRenderer* frame = std::as_const(view_).lastFrame();
  if (!frame || !controller_.document().content.scene) return std::nullopt;
  FrameKey key{frame->baked().channels, frame->camera(), view_.pixels(),
               controller_.session().frame};
  key.settings.view = ViewMode::Shaded;  // it shows the same errors
  return key;
}

bool ErrorController::current() const {
  return taken_ && presentKey() == takenKey_;
}

void ErrorController::refresh() {
  if (!watched_) return;
  shownObstacle_ = obstacle();
  outlineInView();
  if (!shownObstacle_.isEmpty() || current()) {
    still_.stop();
    stop();
  } else if (!working_ || presentKey() != workKey_) {
    stop();
    still_.start();
  }
  emit changed();
}

void ErrorController::start() {
  // Where a frame is still to come, its arrival asks again.
  if (!watched_ || !obstacle().isEmpty() || current() || !view_.upToDate()) return;
  try {
    view_.makeCurrent();
    computeBeside(view_.lastFrame()->snapshot());
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
  }
  emit changed();
}

void ErrorController::computeBeside(const std::shared_ptr<const FrameSnapshot>& frame) {
  workKey_ = *presentKey();
  working_ = true;
  done_ = std::make_shared<std::atomic<double>>(0.0);
  tick_.start();
  thread_ = std::jthread([this, frame, done = done_, key = workKey_,
                          number = ++asked_](const std::stop_token& stopped) {
    struct Stopped {};
    try {
      const auto taken = takenApart(*frame, [&](double part) {
        if (stopped.stop_requested()) throw Stopped{};
        *done = part;
      });
      QMetaObject::invokeMethod(
          this, [=, this] { finished(number, taken, key); }, Qt::QueuedConnection);
    } catch (const Stopped&) {
      return;
    } catch (const std::exception& problem) {  // memory, for the largest pictures
      const QString message = QString::fromUtf8(problem.what());
      QMetaObject::invokeMethod(
          this, [=, this] { gaveUp(number, message); }, Qt::QueuedConnection);
    }
  });
}

void ErrorController::stop() {
  ++asked_;  // what is on its way is of an older frame
  thread_.request_stop();
  working_ = false;
  tick_.stop();
}

void ErrorController::finished(int number, const std::shared_ptr<const Taken>& taken,
                               const FrameKey& key) {
  if (number != asked_) return;
  stop();
  taken_ = taken;
  takenKey_ = key;
  sumUp();
  emit changed();
}

void ErrorController::gaveUp(int number, const QString& message) {
  if (number != asked_) return;
  stop();
  emit failed(message);
  emit changed();
}

void ErrorController::sumUp() {
  lassoSums_.reset();
  if (!taken_) return;
  frameSums_ = sumsOf(taken_->errors);
  if (lasso_.isEmpty()) return;
  const int width = taken_->surfaces.width(), height = taken_->surfaces.height();
  const Image<std::uint8_t> mask = maskOf(lassoIn({width, height}), width, height);
  lassoSums_ = sumsOf(taken_->errors, &mask);
}

void ErrorController::setPart(std::optional<ErrorPart> part) {
  if (part == part_) return;
  part_ = part;
  emit changed();
}

// The camera keeps its vertical angle, so lengths scale with the height, about the picture's
// middle.
QPolygonF ErrorController::lassoIn(const QSize& size) const {
  if (lasso_.isEmpty() || size == lassoSize_) return lasso_;
  const double scale = double(size.height()) / lassoSize_.height();
  const QPointF from(lassoSize_.width() / 2.0, lassoSize_.height() / 2.0);
  const QPointF to(size.width() / 2.0, size.height() / 2.0);
  QPolygonF scaled;
  for (const QPointF& point : lasso_) scaled << to + (point - from) * scale;
  return scaled;
}

void ErrorController::setLasso(const QPolygonF& lasso, const QSize& size) {
  if (size.isEmpty() && !lasso.isEmpty()) return;  // its picture has gone since it was begun
  lasso_ = lasso;
  lassoSize_ = size;
  sumUp();
  outlineInView();
  emit changed();
}

void ErrorController::outlineInView() {
  view_.setSelection(watched_ && obstacle().isEmpty() ? lassoIn(view_.pixels()) : QPolygonF());
}

void ErrorController::pin(int x, int y) {
  if (current()) prober_.pin({x, y});
}

void ErrorController::goToWorst() {
  if (!current()) return;
  const int width = taken_->surfaces.width(), height = taken_->surfaces.height();
  const Image<std::uint8_t> mask = maskOf(lassoIn({width, height}), width, height);
  if (const auto worst = worstPixel(taken_->errors, part_, lasso_.isEmpty() ? nullptr : &mask))
    prober_.pin({worst->x, worst->y});
}

}  // namespace umbra

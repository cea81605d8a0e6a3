#include "ui/probe/Prober.h"

#include <cmath>
#include <exception>
#include <utility>

#include "analysis/errors/WorstPixel.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

// A pixel of a picture of the session's size in one of another size: the camera keeps its vertical
// angle, so that both centres show the same point and lengths follow the height.
Pixel scaledPixel(const Pixel& pixel, const Session& session, const QSize& to) {
  const double scale = double(to.height()) / session.height;
  const auto along = [scale](int value, int from, int size) {
    return int(std::floor((value + 0.5 - from / 2.0) * scale + size / 2.0));
  };
  return {along(pixel.x, session.width, to.width()), along(pixel.y, session.height, to.height())};
}

}  // namespace

Prober::Prober(SessionController& controller, SceneView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view), taker_(controller, view) {
  connect(&view_, &SceneView::frameDrawn, this, &Prober::refresh);
  connect(&view_, &SceneView::hovered, this, &Prober::hover);
  connect(&view_, &SceneView::clicked, this, &Prober::pin);
  connect(&view_, &SceneView::failed, this, &Prober::refresh);
  connect(&controller_, &SessionController::changed, this, &Prober::sessionChanged);
}

void Prober::sessionChanged(const Document& before, const Document& after) {
  const bool moved = !(before.session.probe == after.session.probe);
  const NamedProbe* saved = savedProbe();
  if (saved && saved->point && !(held_ && held_->point() == *saved->point))
    holdPoint(saved->point);
  else if (moved && !saved && after.session.probe)
    held_.reset();
  if (!(before.content == after.content)) {
    hover_.reset();
    held_.reset();
    report_.reset();
    answered_.reset();
    emit reported();
  }
  if (after.content.depth) refresh();  // a scene is probed after the frame that follows
}

// Returns the saved probe that the session's probe is at; null where it is at none.
const NamedProbe* Prober::savedProbe() const {
  const Session& session = controller_.session();
  return session.probe ? probeNamed(session.probes, session.keptProbe) : nullptr;
}

void Prober::holdPoint(const std::optional<Eigen::Vector3d>& point) {
  if (point)
    held_.emplace(*point);
  else
    held_.reset();
}

std::optional<Eigen::Vector3d> Prober::pinnedPoint() const {
  if (!controller_.session().probe || !held_) return std::nullopt;
  return held_->point();
}

void Prober::setVeil(const QString& reason) {
  if (reason == veil_) return;
  veil_ = reason;
  // What is seen again is shown once all have heard of what lifts the veil.
  if (reason.isEmpty())
    QMetaObject::invokeMethod(this, &Prober::showAgain, Qt::QueuedConnection);
  else
    emit reported();
}

void Prober::showAgain() {
  if (answered_ == question())
    emit reported();
  else
    refresh();
}

void Prober::hover(const Pixel& pixel) {
  if (controller_.session().probe) return;
  hover_ = pixel;
  refresh();
}

void Prober::pin(const Pixel& pixel) {
  const bool onScene = controller_.document().content.scene != nullptr;
  if (onScene && !view_.surfaceAt(pixel)) return;  // the sky has no shadow to take apart
  settlePixel();
  // The pixel of the present report shows the point that is held: there is nothing new to read.
  const bool here = report_ && report_->pinned && report_->inSight && report_->pixel == pixel &&
                    answered_ == question();
  if (!here) held_.reset();
  controller_.edit(tr("Pin probe"), [&](Session& session) {
    place(session, pixel);
    if (onScene) session.receiver.reset();
  });
  refresh();
}

void Prober::place(Session& session, const Pixel& at) const {
  session.probe = at;
  session.keptProbe.clear();
  if (!controller_.document().content.scene) return;
  session.width = view_.pixels().width();
  session.height = view_.pixels().height();
}

void Prober::unpin() {
  settlePixel();
  hover_.reset();
  controller_.edit(tr("Unpin probe"), [](Session& session) {
    session.probe.reset();
    session.keptProbe.clear();
    session.receiver.reset();
  });
  refresh();
}

std::optional<Pixel> Prober::findWorstBleeding() {
  ShadowRenderer* frame = view_.lastFrame();
  if (!frame || view_.stale()) return std::nullopt;
  try {
    const auto worst = worstBleeding(frame->surfaces(), frame->reference());
    return worst ? std::optional(Pixel{worst->x, worst->y}) : std::nullopt;
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
    return std::nullopt;
  }
}

void Prober::pinWorstBleeding() {
  if (const auto worst = findWorstBleeding()) pin(*worst);
}

void Prober::startAtWorstBleeding() {
  const auto worst = findWorstBleeding();
  if (!worst) return;
  controller_.amend([&](Session& session) { place(session, *worst); });
  refresh();
}

// The session has the pixel of a click; the camera may have moved since.
void Prober::settlePixel() {
  const Session& before = controller_.session();
  if (!before.probe || !held_ || !before.keptProbe.empty()) return;
  if (const auto pixel = view_.pixelOf(held_->point()))
    controller_.amend([&](Session& session) { place(session, *pixel); });
}

Prober::Question Prober::question() const {
  const Document& document = controller_.document();
  const Session& session = document.session;
  Question question{document.content,
                    session.frame,
                    session.technique,
                    controller_.techniques(),
                    session.probe,
                    {},
                    {},
                    session.keptProbe,
                    session.receiver};
  if (!session.probe) question.hovered = hover_;
  if (held_) question.held = held_->point();
  const ShadowRenderer* frame = std::as_const(view_).lastFrame();
  if (!frame || !document.content.scene) return question;
  question.drawn = true;
  question.baked = frame->baked();
  question.camera = frame->camera();
  question.pixels = view_.pixels();
  return question;
}

void Prober::refresh() {
  // A frame of other settings, or of another scene, says nothing of the present ones; the one that
  // follows is probed.
  if (controller_.document().content.scene && view_.stale()) return;
  if (answered_ == question()) return;
  try {
    answered_.reset();
    report_ = take();
    answered_ = question();  // the place may have been found only now
    emit reported();
  } catch (const std::exception& problem) {
    report_.reset();  // of settings that are gone
    emit reported();
    emit failed(QString::fromUtf8(problem.what()));
  }
}

std::optional<ProbeReport> Prober::take() {
  const Session& session = controller_.session();
  const std::optional<Pixel> at = session.probe ? session.probe : hover_;
  if (!at) return std::nullopt;
  std::optional<ProbeReport> report;
  if (controller_.document().content.depth)
    report = taker_.at(*at, session.receiver);
  else if (const auto place = currentPlace())
    report = taker_.at(*place, session.receiver);
  if (report) report->pinned = session.probe.has_value();
  return report;
}

// A pinned probe stays on its point of the surface while the camera moves. What was last in sight
// stays to be read, with what is now set: the map is there to be read.
std::optional<SurfacePlace> Prober::currentPlace() {
  if (!view_.lastFrame()) return std::nullopt;
  const Document& document = controller_.document();
  const Session& session = document.session;
  const NamedProbe* saved = savedProbe();
  if (!held_ && saved && saved->point) held_.emplace(*saved->point);
  if (!session.probe || !held_) {
    const Pixel pixel =
        session.probe ? scaledPixel(*session.probe, session, view_.pixels()) : *hover_;
    if (auto place = placeAt(view_, pixel)) {
      held_.emplace(*place, view_, document);
      return place;
    }
  }
  if (!held_) return std::nullopt;
  const auto found = held_->find(view_, document);
  const SurfacePlace* place = std::get_if<SurfacePlace>(&found);
  return place ? std::optional(*place) : std::nullopt;
}

}  // namespace umbra

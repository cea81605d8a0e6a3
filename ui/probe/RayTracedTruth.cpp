#include "ui/probe/RayTracedTruth.h"

#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <utility>

#include "analysis/rays/RayTracedVisibility.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

// Hovering over a picture may ask for every texel in the end.
int sideOf(int mapSize, std::size_t cascades) {
  return std::min(RayTracedVisibility::largestSide,
                  RayTracedVisibility::sideFor(mapSize, int(cascades)));
}

}  // namespace

RayTracedTruth::RayTracedTruth(SessionController& controller, SceneView& view, Prober& prober,
                               QObject* parent)
    : QObject(parent), controller_(controller), view_(view), prober_(prober) {
  connect(&prober_, &Prober::reported, this, &RayTracedTruth::follow);
}

RayTracedTruth::~RayTracedTruth() = default;

bool RayTracedTruth::applies() const {
  return controller_.document().content.scene != nullptr;
}

std::optional<RayTracedTruth::Job> RayTracedTruth::jobOf() const {
  const auto& report = prober_.report();
  const ShadowRenderer* frame = view_.lastFrame();
  if (!applies() || !report || !frame) return std::nullopt;
  return Job{reports_,
             frame->baked().maps,
             controller_.document().content.scene,
             frame->cascades(),
             report->request->map.width(),
             controller_.session().frame.bias.cullFrontFaces,
             report->probe.region,
             report->probe.receiver};
}

void RayTracedTruth::follow() {
  visibility_.reset();
  ++reports_;
  std::optional<Job> job = jobOf();
  if (!busy_ && !applies()) rays_.reset();
  if (busy_)
    next_ = std::move(job);
  else if (job)
    start(std::move(*job));
}

void RayTracedTruth::start(Job job) {
  busy_ = true;
  thread_ = std::jthread([this, job = std::move(job)] {
    std::optional<double> visibility;
    try {
      if (!rays_ || raysOf_ != job.maps)
        rays_ = std::make_unique<RayTracedVisibility>(*job.scene, job.cascades, job.mapSize,
                                                      job.cullFrontFaces,
                                                      sideOf(job.mapSize, job.cascades.size()));
      raysOf_ = job.maps;
      visibility = (*rays_)(job.region, job.receiver);
    } catch (const std::exception&) {
      rays_.reset();  // the row stays without a figure, as where there is no tracer
    }
    QMetaObject::invokeMethod(
        this, [this, number = job.number, visibility] { finished(number, visibility); },
        Qt::QueuedConnection);
  });
}

void RayTracedTruth::finished(int number, std::optional<double> visibility) {
  busy_ = false;
  if (number == reports_ && visibility) {
    visibility_ = visibility;
    emit traced();
  }
  if (std::optional<Job> job = std::exchange(next_, std::nullopt)) start(std::move(*job));
}

}  // namespace umbra

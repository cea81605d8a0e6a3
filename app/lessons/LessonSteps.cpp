#include "app/lessons/LessonSteps.h"

#include <algorithm>
#include <utility>

#include "analysis/errors/BleedReduction.h"
#include "analysis/errors/Measure.h"
#include "app/options/SceneSources.h"
#include "app/output/Cancellation.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// The techniques whose whole frame is measured at `step`.
std::vector<std::string> framesOf(const Lesson& lesson, std::size_t step) {
  std::vector<std::string> ids;
  const auto add = [&](const LessonQuantity& quantity) {
    if (quantity.step == step && infoOf(quantity.quantity).ofFrame &&
        std::find(ids.begin(), ids.end(), quantity.technique) == ids.end())
      ids.push_back(quantity.technique);
  };
  for (const LessonStep& one : lesson.steps)
    for (const LessonClaim& claim : one.claims) {
      add(claim.left);
      if (claim.right) add(*claim.right);
    }
  return ids;
}

Metrics metricsOf(HeadlessFrame& frame, const Technique& technique) {
  frame.render(technique, ViewMode::Shaded);
  MetricsSum sum;
  for (const BoundSample& sample : boundSamplesOf(frame.surfaces(), frame.reference()))
    sum.add(sample.bound, sample.reference);
  return sum.result();
}

// The step's session in a picture of that shape.
Session sessionIn(const LessonStep& step, const std::optional<PictureShape>& shape) {
  Session session = step.session;
  if (!shape) return session;
  session.width = shape->width;
  session.height = shape->height;
  return session;
}

// `frame` shows `session`.
StepResult measure(HeadlessFrame& frame, const Session& session, const Lesson& lesson,
                   std::size_t step) {
  const TechniqueCatalogue catalogue = allTechniques();
  std::vector<std::shared_ptr<Technique>> techniques;
  for (const std::string& id : techniquesOf(lesson, step))
    techniques.push_back(techniqueOf(session, catalogue, id));
  const NamedProbe point{lessonProbe, lesson.steps[step].at, {}, session.receiver};
  SavedSceneProbe probe = probeSaved(frame, session, techniques, {point}, {}).front();
  if (!probe.probe) throw Error(ErrorKind::BadInput, "at: " + probe.reason);
  StepResult result{std::move(*probe.probe), {}, {}};
  if (!result.probe.probe.refused.empty())
    throw Error(ErrorKind::BadInput, result.probe.probe.refused.front().reason);
  for (const std::string& id : framesOf(lesson, step)) {
    throwIfCancelled();
    result.metrics[id] = metricsOf(frame, *techniqueOf(session, catalogue, id));
  }
  frame.render(*techniques.front(), session.frame.view);
  result.picture = frame.colour();
  return result;
}

}  // namespace

class LessonMeasurer::Scenes {
 public:
  explicit Scenes(Display& display) : display_(display) {}

  HeadlessFrame& show(const Session& session) {
    const std::shared_ptr<const Scene> scene = scenes_.scene(session.source);
    if (frame_)
      frame_->show(scene, session);
    else
      frame_ = display_.makeFrame(scene, session);
    return *frame_;
  }

 private:
  Display& display_;
  SceneLoader scenes_;
  std::unique_ptr<HeadlessFrame> frame_;
};

LessonMeasurer::LessonMeasurer(Display& display) : scenes_(std::make_unique<Scenes>(display)) {}

LessonMeasurer::~LessonMeasurer() = default;

std::vector<StepResult> LessonMeasurer::steps(const Lesson& lesson,
                                              const std::optional<PictureShape>& shape) {
  std::vector<StepResult> results;
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    throwIfCancelled();
    try {
      const Session session = sessionIn(lesson.steps[step], shape);
      results.push_back(measure(scenes_->show(session), session, lesson, step));
    } catch (const Error& error) {
      // What is wrong is in the lesson, not among the options of this command.
      const bool input =
          error.kind() == ErrorKind::BadCommandLine || error.kind() == ErrorKind::BadInput;
      throw Error(
          input ? ErrorKind::BadInput : error.kind(),
          "lesson " + lesson.name + ": steps[" + std::to_string(step + 1) + "]: " + error.what());
    }
  }
  return results;
}

double valueOf(const std::vector<StepResult>& results, const LessonQuantity& quantity) {
  const StepResult& step = results.at(quantity.step);
  if (infoOf(quantity.quantity).ofFrame)
    return measured(step.metrics.at(quantity.technique), quantity.quantity);
  return measured(step.probe.probe, quantity.quantity, quantity.technique).value();
}

ClaimResult checkClaim(const std::vector<StepResult>& results, const LessonClaim& claim) {
  ClaimResult result;
  result.left = valueOf(results, claim.left);
  result.right = claim.right ? valueOf(results, *claim.right) : claim.value;
  result.holds = holds(claim, result.left, result.right);
  return result;
}

}  // namespace umbra

// When the panes' pictures are drawn.
#include <algorithm>
#include <exception>

#include "filters/core/TechniqueEquality.h"
#include "ui/ComparisonPanes.h"
#include "ui/SceneView.h"
#include "ui/SessionController.h"
#include "ui/widgets/Style.h"

namespace umbra {
namespace {

constexpr int rest = 120;  // milliseconds without a new frame before the other panes follow

}  // namespace

PictureSubject ComparisonPanes::subject() const {
  const Document& document = controller_.document();
  const std::shared_ptr<const Scene>& scene = document.content.scene;
  // The camera as the mouse moves it, which the session learns of when it rests.
  return {scene, document.session.light.value_or(scene->light), view_.lastFrame()->camera(),
          document.session.frame, view_.pixels()};
}

const std::shared_ptr<const Technique>& ComparisonPanes::techniqueOf(const std::string& id) const {
  const auto& techniques = controller_.techniques();
  return *std::find_if(techniques.begin(), techniques.end(),
                       [&](const auto& technique) { return technique->info().id == id; });
}

bool ComparisonPanes::isCurrent(const std::string& id) const {
  const auto found = drawn_.find(id);
  return found != drawn_.end() && view_.lastFrame() && found->second.subject == subject() &&
         sameSettings(*found->second.technique, *techniqueOf(id));
}

std::vector<std::string> ComparisonPanes::outOfDate() const {
  std::vector<std::string> ids;
  for (const std::string& id : shown_)
    if (id != live_ && !isCurrent(id)) ids.push_back(id);
  return ids;
}

bool ComparisonPanes::upToDate() const {
  return arranged_ == ComparisonMode::Single || outOfDate().empty();
}

void ComparisonPanes::schedule() {
  if (arranged_ == ComparisonMode::Single || !view_.lastFrame() || view_.pixels().isEmpty() ||
      outOfDate().empty())
    return;
  const PictureSubject wanted = subject();
  // What goes on being asked for is not put off again.
  if (timer_.isActive() && wanted == scheduled_) return;
  scheduled_ = wanted;
  timer_.start(arranged_ == ComparisonMode::Wipe ? 0 : rest);
}

// One at a time: what a person does meanwhile comes first.
void ComparisonPanes::drawNext() {
  if (arranged_ == ComparisonMode::Single || !view_.lastFrame()) return;
  const std::vector<std::string> waiting = outOfDate();
  if (waiting.empty()) return;
  std::erase_if(drawn_, [this](const auto& entry) {
    return std::find(shown_.begin(), shown_.end(), entry.first) == shown_.end();
  });
  drawn_[waiting.front()] = drawingOf(waiting.front());
  showPictures();
  if (waiting.size() > 1) timer_.start(0);
}

ComparisonPanes::Drawn ComparisonPanes::drawingOf(const std::string& id) {
  Drawn drawn{subject(), techniqueOf(id), {}, controller_.refusals().value(style::text(id))};
  if (!drawn.problem.isEmpty()) return drawn;
  try {
    if (!renderer_) renderer_ = std::make_unique<TechniquePictures>();
    drawn.picture = renderer_->draw(drawn.subject, *drawn.technique);
    drawn.picture.setDevicePixelRatio(view_.devicePixelRatioF());
  } catch (const std::exception& problem) {
    drawn.problem = QString::fromUtf8(problem.what());
    emit failed(drawn.problem);
  }
  return drawn;
}

}  // namespace umbra

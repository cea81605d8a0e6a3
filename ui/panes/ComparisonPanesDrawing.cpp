// When the panes' pictures are drawn.
#include <algorithm>
#include <exception>

#include "filters/core/technique/TechniqueEquality.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

constexpr int rest = 120;  // milliseconds without a new frame before the other panes follow
// Pictures kept: what one comes back to, such as by undo, is there at once.
constexpr std::size_t kept = Comparison::most + 2;

}  // namespace

PictureSubject ComparisonPanes::subject(std::size_t pane) const {
  const Document& document = controller_.document();
  const std::shared_ptr<const Scene>& scene = document.content.scene;
  // The camera as the mouse moves it, which the session learns of when it rests.
  return {scene, document.session.light.value_or(scene->light), view_.camera(),
          shown_[pane].session.frame, view_.pixels()};
}

ComparisonPanes::DrawnPicture ComparisonPanes::drawnAsIs(std::size_t pane) const {
  const PictureSubject wanted = subject(pane);
  for (const DrawnPicture& drawn : recent_)
    if (drawn->subject == wanted && sameSettings(*drawn->technique, *shown_[pane].technique))
      return drawn->picture.isNull() || drawn->kept >= neededEvidence(pane) ? drawn : nullptr;
  return nullptr;
}

// The report tells what a pane with the active one's settings shows; where the live view has the
// same map, that one is read.
KeptEvidence ComparisonPanes::neededEvidence(std::size_t pane) const {
  if (isSetAsActive(pane)) return KeptEvidence::None;
  return sameMap(shown_[pane].session.frame, controller_.session().frame) ? KeptEvidence::Surfaces
                                                                          : KeptEvidence::Maps;
}

std::vector<std::size_t> ComparisonPanes::outOfDate() const {
  std::vector<std::size_t> panes;
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (i != active_ && !drawnAsIs(i)) panes.push_back(i);
  return panes;
}

bool ComparisonPanes::upToDate() const {
  return arranged_ == ComparisonMode::Single || outOfDate().empty();
}

// Until it is drawn anew: the one before the camera or the light moved, else what the pane showed
// of its technique.
ComparisonPanes::DrawnPicture ComparisonPanes::pictureToShow(std::size_t pane) {
  DrawnPicture& latest = latest_[pane];
  const Shown& shown = shown_[pane];
  if (const DrawnPicture drawn = drawnAsIs(pane)) return latest = drawn;
  const auto& scene = controller_.document().content.scene;
  for (const DrawnPicture& drawn : recent_)
    if (drawn->subject.scene == scene && drawn->subject.frame == shown.session.frame &&
        sameSettings(*drawn->technique, *shown.technique))
      return latest = drawn;
  if (latest && (latest->subject.scene != scene ||
                 latest->technique->info().id != shown.technique->info().id))
    latest = nullptr;
  return latest;
}

void ComparisonPanes::showPictures() {
  if (mode() != arranged_) return;  // of another document, to which refresh() is about to come
  if (arranged_ == ComparisonMode::Wipe) {
    const DrawnPicture other = pictureToShow(1 - active_);
    view_.setCurtain(other ? other->picture : QImage(), controller_.session().comparison.wipe,
                     other ? other->problem : QString(), active_ == 1);
    return;
  }
  view_.setCurtain({}, 1.0, {}, false);
  if (arranged_ != ComparisonMode::Grid) return;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (i == active_) continue;
    const DrawnPicture drawn = pictureToShow(i);
    if (!drawn || drawn->picture.isNull())
      pictures_[i]->setMessage(drawn ? drawn->problem : QString());
    else
      pictures_[i]->setPicture(drawn->picture);
    if (!drawnAsIs(i)) continue;  // over an older picture stays the probe of then
    SceneOverlay::Contents contents = view_.overlayContents();
    if (contents.report && figures_[i] && !figures_[i]->footprint.empty())
      contents.report->footprint = figures_[i]->footprint;
    pictures_[i]->setContents(std::move(contents));
  }
}

void ComparisonPanes::schedule() {
  if (arranged_ == ComparisonMode::Single || view_.pixels().isEmpty() || outOfDate().empty())
    return;
  std::vector<PictureSubject> wanted;
  for (std::size_t i = 0; i < shown_.size(); ++i) wanted.push_back(subject(i));
  // What goes on being asked for is not put off again.
  if (timer_.isActive() && wanted == scheduled_) return;
  scheduled_ = std::move(wanted);
  timer_.start(arranged_ == ComparisonMode::Wipe ? 0 : rest);
}

// One at a time: what a person does meanwhile comes first.
void ComparisonPanes::drawNext() {
  if (arranged_ == ComparisonMode::Single) return;
  const std::vector<std::size_t> waiting = outOfDate();
  if (waiting.empty()) return;
  keep(draw(waiting.front()));
  refreshFigures();
  showPictures();
  if (waiting.size() > 1) timer_.start(0);
}

// What a pane shows stays, however long ago it was drawn; of the others the oldest goes.
void ComparisonPanes::keep(const DrawnPicture& picture) {
  std::vector<DrawnPicture> shown;
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (i != active_) shown.push_back(drawnAsIs(i));
  std::stable_partition(recent_.begin(), recent_.end(), [&](const DrawnPicture& drawn) {
    return std::find(shown.begin(), shown.end(), drawn) != shown.end();
  });
  recent_.insert(recent_.begin(), picture);
  if (recent_.size() > kept) recent_.pop_back();
}

ComparisonPanes::DrawnPicture ComparisonPanes::draw(std::size_t pane) {
  const Shown& shown = shown_[pane];
  auto drawn = std::make_shared<Drawn>(
      Drawn{subject(pane), shown.technique, {}, {}, neededEvidence(pane), shown.refusal});
  if (!drawn->problem.isEmpty()) return drawn;
  try {
    if (!renderer_) renderer_ = std::make_unique<TechniquePictures>();
    TechniqueDrawing drawing = renderer_->draw(drawn->subject, *drawn->technique, drawn->kept);
    drawn->picture = std::move(drawing.picture);
    drawn->evidence = std::move(drawing.evidence);
    drawn->picture.setDevicePixelRatio(view_.devicePixelRatioF());
  } catch (const std::exception& problem) {
    drawn->problem = QString::fromUtf8(problem.what());
    emit failed(drawn->problem);
  }
  return drawn;
}

}  // namespace umbra

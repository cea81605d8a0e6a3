#include "ui/panes/PanePictures.h"

#include <algorithm>
#include <exception>

#include "filters/core/technique/TechniqueEquality.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

constexpr int rest = 120;  // milliseconds without a new frame before the other panes follow
// So many pictures are kept, so that what a person comes back to, such as by undo, is there at
// once.
constexpr std::size_t kept = Comparison::most + 2;

}  // namespace

PanePictures::PanePictures(const ShownPanes& shown, const SessionController& controller,
                           SceneView& view, QObject* parent)
    : QObject(parent),
      shown_(shown),
      controller_(controller),
      view_(view),
      latest_(Comparison::most) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &PanePictures::drawNext);
}

PanePictures::~PanePictures() = default;

PictureSubject PanePictures::subject(std::size_t pane) const {
  const Document& document = controller_.document();
  const std::shared_ptr<const Scene>& scene = document.content.scene;
  // The camera is the view's, since the session learns of it only when the mouse rests.
  return {scene, document.session.light.value_or(scene->light), view_.camera(),
          shown_[pane].session.frame, view_.pixels()};
}

PanePictures::Picture PanePictures::current(std::size_t pane) const {
  const PictureSubject wanted = subject(pane);
  for (const Picture& drawn : recent_)
    if (drawn->subject == wanted && sameSettings(*drawn->technique, *shown_[pane].technique))
      return drawn->picture.isNull() || drawn->frame || !needsFrame(pane) ? drawn : nullptr;
  return nullptr;
}

// Whether the pane is probed in a frame of its own: where it is set as the active one, the live
// view's report tells what it shows.
bool PanePictures::needsFrame(std::size_t pane) const {
  return !isSetAsActive(shown_[pane], controller_);
}

std::vector<std::size_t> PanePictures::outOfDate() const {
  std::vector<std::size_t> panes;
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (i != shown_.active && !current(i)) panes.push_back(i);
  return panes;
}

bool PanePictures::upToDate() const {
  return shown_.mode == ComparisonMode::Single || outOfDate().empty();
}

PanePictures::Picture PanePictures::latest(std::size_t pane) {
  Picture& latest = latest_[pane];
  const ShownPane& shown = shown_[pane];
  if (const Picture drawn = current(pane)) return latest = drawn;
  const auto& scene = controller_.document().content.scene;
  for (const Picture& drawn : recent_)
    if (drawn->subject.scene == scene && drawn->subject.frame == shown.session.frame &&
        sameSettings(*drawn->technique, *shown.technique))
      return latest = drawn;
  if (latest && (latest->subject.scene != scene ||
                 latest->technique->info().id != shown.technique->info().id))
    latest = nullptr;
  return latest;
}

void PanePictures::schedule() {
  if (view_.pixels().isEmpty() || upToDate()) return;
  std::vector<PictureSubject> wanted;
  for (std::size_t i = 0; i < shown_.size(); ++i) wanted.push_back(subject(i));
  // While the same pictures are asked for again and again, they are not put off again.
  if (timer_.isActive() && wanted == scheduled_) return;
  scheduled_ = std::move(wanted);
  timer_.start(shown_.mode == ComparisonMode::Wipe ? 0 : rest);
}

void PanePictures::drawNext() {
  if (shown_.mode == ComparisonMode::Single) return;
  const std::vector<std::size_t> waiting = outOfDate();
  if (waiting.empty()) return;
  keep(draw(waiting.front()));
  emit drawn();
  if (waiting.size() > 1) timer_.start(0);
}

// What a pane shows stays, however long ago it was drawn; of the other pictures the oldest goes.
void PanePictures::keep(const Picture& picture) {
  std::vector<Picture> inSight;
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (i != shown_.active) inSight.push_back(current(i));
  std::stable_partition(recent_.begin(), recent_.end(), [&](const Picture& drawn) {
    return std::find(inSight.begin(), inSight.end(), drawn) != inSight.end();
  });
  recent_.insert(recent_.begin(), picture);
  if (recent_.size() > kept) recent_.pop_back();
}

PanePictures::Picture PanePictures::draw(std::size_t pane) {
  const ShownPane& shown = shown_[pane];
  auto drawn = std::make_shared<DrawnPane>(
      DrawnPane{subject(pane), shown.technique, {}, nullptr, shown.refusal});
  if (!drawn->problem.isEmpty()) return drawn;
  try {
    if (!renderer_) renderer_ = std::make_unique<TechniquePictures>();
    drawn->picture = renderer_->draw(drawn->subject, *drawn->technique);
    if (needsFrame(pane)) drawn->frame = renderer_->snapshot(view_.lastFrame());
    drawn->picture.setDevicePixelRatio(view_.devicePixelRatioF());
  } catch (const std::exception& problem) {
    drawn->problem = QString::fromUtf8(problem.what());
    emit failed(drawn->problem);
  }
  return drawn;
}

}  // namespace umbra

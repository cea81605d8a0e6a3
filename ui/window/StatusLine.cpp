#include "ui/window/StatusLine.h"

#include <QLabel>
#include <QStatusBar>

#include "ui/picture/FrameFigures.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int messageTime = 6000;  // milliseconds

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, SessionController& controller, SceneView& view)
    : QObject(&bar),
      bar_(bar),
      controller_(controller),
      view_(view),
      scene_(new QLabel),
      frame_(new QLabel),
      map_(new QLabel) {
  for (QLabel* label : {scene_, frame_, map_}) label->setTextFormat(Qt::PlainText);
  scene_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  bar_.addWidget(scene_, 1);
  for (QLabel* label : {frame_, map_}) {
    label->setFont(style::figures(label->font()));
    bar_.addPermanentWidget(label);
  }
  connect(&controller_, &SessionController::changed, this, &StatusLine::refresh);
  connect(&view_, &SceneView::frameDrawn, this, &StatusLine::showFrame);
  refresh();
}

void StatusLine::showMessage(const QString& text) {
  bar_.showMessage(text, messageTime);
}

void StatusLine::refresh() {
  showScene();
  showFrame();
}

// A notice about what the storage format does to a parameter matters more than which scene is open.
void StatusLine::showScene() {
  const QString title = style::text(titleOf(controller_.session().source));
  const Scene* scene = controller_.document().content.scene.get();
  if (!controller_.notices().isEmpty())
    scene_->setText(controller_.notices().join("  "));
  else if (scene && !scene->figure.empty())
    scene_->setText(title + QStringLiteral(" · ") + style::text(scene->figure));
  else
    scene_->setText(title);
}

void StatusLine::showFrame() {
  if (const DepthMap* depth = controller_.document().content.depth.get()) {
    frame_->clear();
    map_->setToolTip({});
    map_->setText(tr("%1 × %2 texels").arg(depth->width()).arg(depth->height()));
    return;
  }
  const auto times = view_.lastFrame() ? view_.lastFrame()->passTimes() : std::vector<PassTime>{};
  frame_->setText(passTimesText(times));
  map_->setToolTip(mapToolTip());
  map_->setText(mapText(controller_.session().frame, controller_.technique()));
}

}  // namespace umbra

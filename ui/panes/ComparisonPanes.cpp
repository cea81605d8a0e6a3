#include "ui/panes/ComparisonPanes.h"

#include <QGridLayout>
#include <QToolButton>

#include "datasets/session/PaneEditing.h"
#include "ui/panes/PaneHeader.h"
#include "ui/panes/PaneMenu.h"
#include "ui/panes/WipeHandle.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

ComparisonPanes::ComparisonPanes(SessionController& controller, SceneView& view, Prober& prober,
                                 QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      view_(view),
      prober_(prober),
      grid_(new QGridLayout(this)),
      wipe_(nullptr),
      more_(new QToolButton(this)),
      figures_(Comparison::most),
      latest_(Comparison::most) {
  setObjectName("comparison");
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(0);
  view_.setParent(this);
  wipe_ = new WipeHandle(&view_);
  makePanes();
  more_->setText(tr("+ Duplicate the active pane"));
  more_->setToolTip(tr("To be set otherwise: the copy has settings of its own"));
  more_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  more_->setStyleSheet(QString("QToolButton { border: none; color: %1; background: %2; }"
                               "QToolButton:hover { color: %3; }")
                           .arg(style::muted.name(), style::ground.name(), style::ink.name()));
  connect(more_, &QToolButton::clicked, this, [this] {
    controller_.edit(tr("Duplicate pane"),
                     [this](Session& session) { duplicatePane(session, active_); });
  });
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &ComparisonPanes::drawNext);
  connect(wipe_, &WipeHandle::moved, this, [this](double at) {
    controller_.edit(
        tr("Move wipe"), [&](Session& session) { session.comparison.wipe = at; }, "wipe");
  });
  connect(wipe_, &WipeHandle::released, this, [this] { controller_.endMerge(); });
  connect(&controller_, &SessionController::changed, this, &ComparisonPanes::refresh);
  connect(&view_, &SceneView::frameDrawn, this, &ComparisonPanes::schedule);
  connect(&prober_, &Prober::reported, this, [this] {
    refreshFigures();
    showPictures();
  });
  arrange();
}

ComparisonPanes::~ComparisonPanes() = default;

void ComparisonPanes::makePanes() {
  for (std::size_t i = 0; i < Comparison::most; ++i) {
    auto* menu = new PaneMenu(controller_, i, this);
    auto* header = new PaneHeader(controller_.catalogue().all(), *menu, this);
    auto* picture = new TechniquePicture(this);
    connect(header, &PaneHeader::techniqueChosen, this, [this, i](const QString& id) {
      controller_.edit(tr("Choose technique"),
                       [&](Session& session) { choosePane(session, i, id.toStdString()); });
    });
    const auto activate = [this, i] {
      if (i == active_) return;
      controller_.edit(tr("Choose pane"), [&](Session& session) { activatePane(session, i); });
    };
    connect(header, &PaneHeader::chosen, this, activate);
    connect(picture, &TechniquePicture::chosen, this, activate);
    connect(picture, &TechniquePicture::hovered, &prober_, &Prober::hover);
    headers_.push_back(header);
    menus_.push_back(menu);
    pictures_.push_back(picture);
  }
}

ComparisonMode ComparisonPanes::mode() const {
  const Document& document = controller_.document();
  return document.content.scene ? document.session.comparison.mode : ComparisonMode::Single;
}

std::vector<std::string> ComparisonPanes::shown() const {
  std::vector<std::string> techniques;
  for (const Shown& pane : shown_) techniques.push_back(pane.session.technique);
  return techniques;
}

// The place that is left is no part of it.
QPixmap ComparisonPanes::snapshot() {
  const QString text = more_->text();
  more_->setText({});
  const QPixmap panes = grab();
  more_->setText(text);
  return panes;
}

void ComparisonPanes::refresh() {
  arrange();
  refreshFigures();
  wipe_->setPosition(controller_.session().comparison.wipe);
  showPictures();
  schedule();
}

}  // namespace umbra

#include "ui/panes/ComparisonPanes.h"

#include <QToolButton>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/PaneEditing.h"
#include "datasets/session/PaneLabels.h"
#include "ui/panes/PaneGrid.h"
#include "ui/panes/PaneHeader.h"
#include "ui/panes/PaneMenu.h"
#include "ui/panes/PanePictures.h"
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
      pictures_(new PanePictures(shown_, controller, view, this)),
      figures_(Comparison::most),
      more_(new QToolButton(this)) {
  setObjectName("comparison");
  view_.setParent(this);
  wipe_ = new WipeHandle(&view_);
  for (std::size_t i = 0; i < Comparison::most; ++i) makePane(i);
  makeMore();
  grid_ = new PaneGrid(*this, view_, {headers_, techniquePictures_, wipe_, more_});
  connect(wipe_, &WipeHandle::moved, this, [this](double at) {
    controller_.editPanes(
        tr("Move wipe"), [&](Workspace& workspace) { workspace.comparison.wipe = at; }, "wipe");
  });
  connect(wipe_, &WipeHandle::released, this, [this] { controller_.endMerge(); });
  connect(&controller_, &SessionController::changed, this, &ComparisonPanes::refresh);
  connect(&view_, &SceneView::frameDrawn, pictures_, &PanePictures::schedule);
  connect(pictures_, &PanePictures::failed, this, &ComparisonPanes::failed);
  const auto follow = [this] {
    refreshFigures();
    showPictures();
  };
  connect(&prober_, &Prober::reported, this, follow);
  connect(pictures_, &PanePictures::drawn, this, follow);
  arrange();
}

ComparisonPanes::~ComparisonPanes() = default;

void ComparisonPanes::makePane(std::size_t pane) {
  auto* menu = new PaneMenu(controller_, pane, this);
  auto* header = new PaneHeader(controller_.catalogue().all(), *menu, this);
  auto* picture = new TechniquePicture(this);
  connect(header, &PaneHeader::techniqueChosen, this, [this, pane](const QString& id) {
    controller_.editPanes(tr("Choose technique"), [&](Workspace& workspace) {
      choosePane(workspace, pane, id.toStdString());
    });
  });
  const auto activate = [this, pane] {
    if (pane == shown_.active) return;
    controller_.editPanes(tr("Choose pane"),
                          [&](Workspace& workspace) { activatePane(workspace, pane); });
  };
  connect(header, &PaneHeader::chosen, this, activate);
  connect(picture, &TechniquePicture::chosen, this, activate);
  connect(picture, &TechniquePicture::hovered, &prober_, &Prober::hover);
  headers_.push_back(header);
  menus_.push_back(menu);
  techniquePictures_.push_back(picture);
}

void ComparisonPanes::makeMore() {
  more_->setText(tr("+ Duplicate the active pane"));
  more_->setToolTip(tr("To be set otherwise: the copy has settings of its own"));
  more_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  more_->setStyleSheet(QString("QToolButton { border: none; color: %1; background: %2; }"
                               "QToolButton:hover { color: %3; }")
                           .arg(style::muted.name(), style::ground.name(), style::ink.name()));
  connect(more_, &QToolButton::clicked, this, [this] {
    controller_.editPanes(tr("Duplicate pane"), [this](Workspace& workspace) {
      duplicatePane(workspace, shown_.active);
    });
  });
}

std::vector<std::string> ComparisonPanes::shown() const {
  std::vector<std::string> techniques;
  for (const ShownPane& pane : shown_.panes) techniques.push_back(pane.session.technique);
  return techniques;
}

// The place that is left for another pane says nothing there.
QPixmap ComparisonPanes::snapshot() {
  const QString text = more_->text();
  more_->setText({});
  const QPixmap panes = grab();
  more_->setText(text);
  return panes;
}

bool ComparisonPanes::upToDate() const {
  return pictures_->upToDate();
}

void ComparisonPanes::refresh() {
  arrange();
  refreshFigures();
  wipe_->setPosition(controller_.workspace().comparison.wipe);
  showPictures();
  pictures_->schedule();
}

void ComparisonPanes::arrange() {
  ShownPanes shown = panesToShow(controller_);
  const bool moved = shown.size() != shown_.size() || shown.mode != shown_.mode ||
                     (shown.mode == ComparisonMode::Grid && shown.active != shown_.active);
  shown_ = std::move(shown);
  if (shown_.size() > 1) labelHeaders();
  if (moved) grid_->arrange(shown_.mode, shown_.size(), shown_.active);
}

void ComparisonPanes::labelHeaders() {
  const std::vector<std::string> labels =
      paneLabels(controller_.workspace(), controller_.catalogue());
  const Comparison comparison = comparisonOf(controller_.workspace());
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    headers_[i]->setRefusals(controller_.refusals(shown_[i].session.frame));
    headers_[i]->setTechnique(style::text(shown_[i].session.technique));
    headers_[i]->setDifferences(style::text(labels[i]));
    headers_[i]->setActive(i == shown_.active);
    headers_[i]->setLinked(comparison.panes[i].linked());
  }
}

void ComparisonPanes::refreshFigures() {
  const auto& report = prober_.report();
  // A depth file may have been opened that refresh() has yet to come to.
  const bool probed = report && controller_.document().content.scene;
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    figures_[i].reset();
    if (i >= shown_.size()) continue;
    if (probed)
      figures_[i] = figuresOf(shown_[i], pictures_->current(i).get(), *report, controller_);
    headers_[i]->setError(figures_[i] ? std::optional(figures_[i]->result.error) : std::nullopt);
  }
  emit figuresChanged();
}

void ComparisonPanes::showPictures() {
  // Another document was opened, and refresh() has yet to come to it.
  if (shownMode(controller_) != shown_.mode) return;
  if (shown_.mode == ComparisonMode::Wipe) {
    const PanePictures::Picture other = pictures_->latest(1 - shown_.active);
    view_.setCurtain(other ? other->picture : QImage(), controller_.workspace().comparison.wipe,
                     other ? other->problem : QString(), shown_.active == 1);
    return;
  }
  view_.setCurtain({}, 1.0, {}, false);
  if (shown_.mode != ComparisonMode::Grid) return;
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (i != shown_.active) showPicture(i);
}

void ComparisonPanes::showPicture(std::size_t pane) {
  TechniquePicture& shown = *techniquePictures_[pane];
  const PanePictures::Picture drawn = pictures_->latest(pane);
  if (!drawn || drawn->picture.isNull())
    shown.setMessage(drawn ? drawn->problem : QString());
  else
    shown.setPicture(drawn->picture);
  if (!pictures_->current(pane)) return;  // an older picture keeps the probe of its time
  SceneOverlay::Contents contents = view_.overlayContents();
  if (contents.report && figures_[pane] && !figures_[pane]->footprint.empty())
    contents.report->footprint = figures_[pane]->footprint;
  shown.setContents(std::move(contents));
}

}  // namespace umbra

// Which panes there are, and where they stand.
#include <QGridLayout>
#include <QToolButton>

#include "datasets/session/PaneLabels.h"
#include "filters/core/technique/Composition.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/panes/PaneHeader.h"
#include "ui/panes/PaneMenu.h"
#include "ui/panes/WipeHandle.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr QSize viewAlone{240, 180}, viewInGrid{140, 90};  // smallest, logical pixels
constexpr int paneGap = 4;

}  // namespace

std::vector<ComparisonPanes::Shown> ComparisonPanes::panesToShow() const {
  const Session& session = controller_.session();
  const TechniqueCatalogue& catalogue = controller_.catalogue();
  std::vector<Shown> panes;
  const auto add = [&](Session pane) {
    std::shared_ptr<const Technique> technique =
        umbra::techniqueOf(pane, catalogue, pane.technique);
    const std::string refusal = whyImpossible(pane.frame, *technique);
    panes.push_back({std::move(pane), std::move(technique), style::text(refusal)});
  };
  if (mode() == ComparisonMode::Single) {
    add(session);
    return panes;
  }
  const std::size_t count = shownPanes(comparisonOf(session));
  for (std::size_t i = 0; i < count; ++i) add(activated(session, i));
  return panes;
}

void ComparisonPanes::arrange() {
  std::vector<Shown> panes = panesToShow();
  const bool grid = mode() == ComparisonMode::Grid;
  const std::size_t active = panes.size() == 1 ? 0 : comparisonOf(controller_.session()).active;
  const bool moved =
      panes.size() != shown_.size() || mode() != arranged_ || (grid && active != active_);
  arranged_ = mode();
  active_ = active;
  shown_ = std::move(panes);
  if (moved) takeApart();
  if (shown_.size() > 1) labelHeaders();
  if (moved) placePanes();
}

void ComparisonPanes::labelHeaders() {
  const std::vector<std::string> labels =
      paneLabels(controller_.session(), controller_.catalogue());
  const Comparison comparison = comparisonOf(controller_.session());
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    headers_[i]->setRefusals(controller_.refusals(shown_[i].session.frame));
    headers_[i]->setTechnique(style::text(shown_[i].session.technique));
    headers_[i]->setDifferences(style::text(labels[i]));
    headers_[i]->setActive(i == active_);
    headers_[i]->setLinked(comparison.panes[i].linked());
  }
}

void ComparisonPanes::placePanes() {
  view_.setMinimumSize(arranged_ == ComparisonMode::Grid ? viewInGrid : viewAlone);
  view_.setFramed(arranged_ == ComparisonMode::Grid);
  wipe_->setVisible(arranged_ == ComparisonMode::Wipe);
  if (arranged_ == ComparisonMode::Grid) return placeGrid();
  const int columns = int(shown_.size());
  for (int i = 0; columns > 1 && i < columns; ++i) {
    grid_->addWidget(headers_[std::size_t(i)], 0, i);
    headers_[std::size_t(i)]->show();
  }
  for (int i = 0; i < columns; ++i) grid_->setColumnStretch(i, 1);
  grid_->setRowStretch(1, 1);
  grid_->addWidget(&view_, 1, 0, 1, columns);
}

void ComparisonPanes::placeGrid() {
  const int count = int(shown_.size()), columns = count <= 4 ? 2 : 3;
  grid_->setHorizontalSpacing(paneGap);
  for (int i = 0; i < count; ++i) {
    const int row = i / columns * 2, column = i % columns;
    const auto pane = std::size_t(i);
    QWidget* body = pictures_[pane];
    if (pane == active_) body = &view_;
    body->setMinimumSize(viewInGrid);
    grid_->addWidget(headers_[pane], row, column);
    grid_->addWidget(body, row + 1, column);
    grid_->setRowStretch(row + 1, 1);
    grid_->setColumnStretch(column, 1);
    headers_[pane]->show();
    body->show();
  }
  more_->setVisible(count % columns != 0);
  if (count % columns != 0) grid_->addWidget(more_, count / columns * 2, count % columns, 2, 1);
}

// The view stays in sight all the while: its OpenGL context goes on.
void ComparisonPanes::takeApart() {
  while (QLayoutItem* item = grid_->takeAt(0)) delete item;
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowStretch(row, 0);
  for (int column = 0; column < grid_->columnCount(); ++column) grid_->setColumnStretch(column, 0);
  grid_->setHorizontalSpacing(0);
  for (PaneHeader* header : headers_) header->hide();
  for (TechniquePicture* picture : pictures_) picture->hide();
  more_->hide();
}

}  // namespace umbra

#include "ui/panes/PaneGrid.h"

#include <QGridLayout>
#include <QToolButton>

#include "ui/panes/PaneHeader.h"
#include "ui/panes/WipeHandle.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"

namespace umbra {
namespace {

constexpr QSize viewAlone{240, 180}, viewInGrid{140, 90};  // smallest, logical pixels
constexpr int paneGap = 4;                                 // logical pixels

}  // namespace

PaneGrid::PaneGrid(QWidget& parent, SceneView& view, PaneWidgets widgets)
    : QObject(&parent), view_(view), widgets_(std::move(widgets)), grid_(new QGridLayout(&parent)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(0);
}

void PaneGrid::arrange(ComparisonMode mode, std::size_t panes, std::size_t active) {
  takeApart();
  const bool grid = mode == ComparisonMode::Grid;
  view_.setMinimumSize(grid ? viewInGrid : viewAlone);
  view_.setFramed(grid);
  widgets_.wipe->setVisible(mode == ComparisonMode::Wipe);
  if (grid)
    placeGrid(int(panes), active);
  else
    placeRow(int(panes));
}

// The view stays in sight all the while: its OpenGL context goes on.
void PaneGrid::takeApart() {
  while (QLayoutItem* item = grid_->takeAt(0)) delete item;
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowStretch(row, 0);
  for (int column = 0; column < grid_->columnCount(); ++column) grid_->setColumnStretch(column, 0);
  grid_->setHorizontalSpacing(0);
  for (PaneHeader* header : widgets_.headers) header->hide();
  for (TechniquePicture* picture : widgets_.pictures) picture->hide();
  widgets_.more->hide();
}

// The view alone, or beneath the headers of a wipe's two sides.
void PaneGrid::placeRow(int panes) {
  for (int i = 0; panes > 1 && i < panes; ++i) {
    grid_->addWidget(widgets_.headers[std::size_t(i)], 0, i);
    widgets_.headers[std::size_t(i)]->show();
  }
  for (int i = 0; i < panes; ++i) grid_->setColumnStretch(i, 1);
  grid_->setRowStretch(1, 1);
  grid_->addWidget(&view_, 1, 0, 1, panes);
}

void PaneGrid::placeGrid(int panes, std::size_t active) {
  const int columns = panes <= 4 ? 2 : 3;
  grid_->setHorizontalSpacing(paneGap);
  for (int i = 0; i < panes; ++i) {
    const int row = i / columns * 2, column = i % columns;
    const auto pane = std::size_t(i);
    QWidget* body = widgets_.pictures[pane];
    if (pane == active) body = &view_;
    body->setMinimumSize(viewInGrid);
    grid_->addWidget(widgets_.headers[pane], row, column);
    grid_->addWidget(body, row + 1, column);
    grid_->setRowStretch(row + 1, 1);
    grid_->setColumnStretch(column, 1);
    widgets_.headers[pane]->show();
    body->show();
  }
  const bool room = panes % columns != 0;
  widgets_.more->setVisible(room);
  if (room) grid_->addWidget(widgets_.more, panes / columns * 2, panes % columns, 2, 1);
}

}  // namespace umbra

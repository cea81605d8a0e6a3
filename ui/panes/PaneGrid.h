// Where the panes of a comparison stand.
#pragma once

#include <QObject>
#include <vector>

#include "datasets/session/Comparison.h"

class QGridLayout;
class QToolButton;
class QWidget;

namespace umbra {

class PaneHeader;
class SceneView;
class TechniquePicture;
class WipeHandle;

// The widgets of the panes, as many as there can be.
struct PaneWidgets {
  std::vector<PaneHeader*> headers;
  std::vector<TechniquePicture*> pictures;
  WipeHandle* wipe;
  QToolButton* more;  // adds a pane, where the grid has a place left
};

// Lays them out in `parent`: the view alone, beneath two headers as a wipe, or in a grid with the
// pictures of the other panes.
class PaneGrid : public QObject {
  Q_OBJECT

 public:
  PaneGrid(QWidget& parent, SceneView& view, PaneWidgets widgets);

  void arrange(ComparisonMode mode, std::size_t panes, std::size_t active);

 private:
  void takeApart();
  void placeRow(int panes);
  void placeGrid(int panes, std::size_t active);

  SceneView& view_;
  PaneWidgets widgets_;
  QGridLayout* grid_;
};

}  // namespace umbra

// The picture alone, as a wipe over two panes, or in a grid of panes.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "ui/panes/PaneFigures.h"
#include "ui/panes/ShownPanes.h"

class QToolButton;

namespace umbra {

class PaneGrid;
class PaneHeader;
class PaneMenu;
class PanePictures;
class Prober;
class SceneView;
class SessionController;
class TechniquePicture;
class WipeHandle;

// The active pane is drawn by the one live view, wherever it is; PanePictures draws the others.
class ComparisonPanes : public QWidget {
  Q_OBJECT

 public:
  // Takes `view` over.
  ComparisonPanes(SessionController& controller, SceneView& view, Prober& prober,
                  QWidget* parent = nullptr);
  ~ComparisonPanes() override;

  // The techniques shown, in the order of the panes; the session's alone where none is compared.
  std::vector<std::string> shown() const;
  std::size_t active() const { return shown_.active; }
  PaneHeader& header(std::size_t pane) { return *headers_[pane]; }
  PaneMenu& menu(std::size_t pane) { return *menus_[pane]; }
  TechniquePicture& picture(std::size_t pane) { return *techniquePictures_[pane]; }
  WipeHandle& wipe() { return *wipe_; }
  // None without a probe, while the probe is hidden from the pane, and until its picture is drawn.
  const std::optional<PaneFigures>& figures(std::size_t pane) const { return figures_[pane]; }
  QPixmap snapshot();  // the panes with their labels
  // Every picture shows what the live view shows.
  bool upToDate() const;

 signals:
  void failed(const QString& message);
  void figuresChanged();

 private:
  void makePane(std::size_t pane);
  void makeMore();
  void refresh();
  void arrange();
  void labelHeaders();
  void refreshFigures();
  void showPictures();
  void showPicture(std::size_t pane);

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  ShownPanes shown_;
  PanePictures* pictures_;
  // As many as there can be panes, in their order.
  std::vector<PaneHeader*> headers_;
  std::vector<PaneMenu*> menus_;
  std::vector<TechniquePicture*> techniquePictures_;
  std::vector<std::optional<PaneFigures>> figures_;
  WipeHandle* wipe_ = nullptr;
  QToolButton* more_;  // another pane, where the grid has a place left
  PaneGrid* grid_ = nullptr;
};

}  // namespace umbra

// The picture alone, as a wipe over two panes, or in a grid of panes.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/session/Session.h"
#include "ui/picture/TechniquePictures.h"

class QGridLayout;
class QToolButton;

namespace umbra {

class PaneHeader;
class PaneMenu;
class Prober;
class SceneView;
class SessionController;
class TechniquePicture;
class WipeHandle;

// What a pane makes of the probed point, with its own settings.
struct PaneFigures {
  TechniqueResult result;
  double reference = 0.0;
  Kernel kernel;
  // World, the outline of its region on the surface; none where it is the report's.
  std::vector<Eigen::Vector3d> footprint;
};

// The active pane is drawn by the one live view, wherever it is. The pictures of the others follow
// it: at once in a wipe, whose halves have to fit together, else when it rests.
class ComparisonPanes : public QWidget {
  Q_OBJECT

 public:
  // Takes `view` over.
  ComparisonPanes(SessionController& controller, SceneView& view, Prober& prober,
                  QWidget* parent = nullptr);
  ~ComparisonPanes() override;

  // The techniques shown, in the order of the panes; the session's alone where none is compared.
  std::vector<std::string> shown() const;
  std::size_t active() const { return active_; }
  PaneHeader& header(std::size_t pane) { return *headers_[pane]; }
  PaneMenu& menu(std::size_t pane) { return *menus_[pane]; }
  TechniquePicture& picture(std::size_t pane) { return *pictures_[pane]; }
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
  // A pane as the session would be with it as the active one.
  struct Shown {
    Session session;
    std::shared_ptr<const Technique> technique;
    QString refusal;  // why it cannot be drawn
  };
  struct Drawn {
    PictureSubject subject;
    std::shared_ptr<const Technique> technique;
    QImage picture;
    FrameEvidence evidence;
    KeptEvidence kept = KeptEvidence::None;
    QString problem;  // why there is no picture
  };
  using DrawnPicture = std::shared_ptr<const Drawn>;

  ComparisonMode mode() const;
  void makePanes();
  void refresh();
  // ComparisonPanesLayout.cpp
  void arrange();
  void labelHeaders();
  void placePanes();
  void placeGrid();
  void takeApart();
  std::vector<Shown> panesToShow() const;
  // ComparisonPanesDrawing.cpp
  void showPictures();
  void schedule();
  void drawNext();
  std::vector<std::size_t> outOfDate() const;
  DrawnPicture drawnAsIs(std::size_t pane) const;  // the picture of exactly what the pane shows
  DrawnPicture pictureToShow(std::size_t pane);
  DrawnPicture draw(std::size_t pane);
  void keep(const DrawnPicture& picture);
  PictureSubject subject(std::size_t pane) const;
  KeptEvidence neededEvidence(std::size_t pane) const;  // to be probed
  // ComparisonPanesFigures.cpp
  void refreshFigures();
  void showErrors();
  // Of the probed point in the last frame; looked for once for all panes.
  std::optional<PaneFigures> figuresOf(std::size_t pane);
  bool isSetAsActive(std::size_t pane) const;

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  QGridLayout* grid_;
  WipeHandle* wipe_;
  QToolButton* more_;                 // another pane, where the grid has a place left
  std::vector<PaneHeader*> headers_;  // as many as there can be panes
  std::vector<PaneMenu*> menus_;
  std::vector<TechniquePicture*> pictures_;
  ComparisonMode arranged_ = ComparisonMode::Single;
  std::vector<Shown> shown_;
  std::size_t active_ = 0;                           // of shown_
  std::vector<std::optional<PaneFigures>> figures_;  // of every pane
  std::vector<DrawnPicture> recent_;                 // the newest first
  std::vector<DrawnPicture> latest_;                 // of every pane, what it showed last
  std::unique_ptr<TechniquePictures> renderer_;      // once something is compared
  std::vector<PictureSubject> scheduled_;
  QTimer timer_;
};

}  // namespace umbra

// The picture alone, as a wipe over two techniques, or in a grid of panes with a technique each.
#pragma once

#include <QTimer>
#include <QWidget>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "datasets/Session.h"
#include "ui/TechniquePictures.h"

class QGridLayout;

namespace umbra {

class PaneHeader;
class Prober;
class SceneView;
class SessionController;
class TechniquePicture;
class WipeHandle;

// The session's technique is drawn by the one live view, wherever its pane is. The pictures of the
// others follow it: at once in a wipe, whose halves have to fit together, else when it rests.
class ComparisonPanes : public QWidget {
  Q_OBJECT

 public:
  // Takes `view` over.
  ComparisonPanes(SessionController& controller, SceneView& view, Prober& prober,
                  QWidget* parent = nullptr);
  ~ComparisonPanes() override;

  // The techniques shown, in the order of the panes; the session's alone where none is compared.
  const std::vector<std::string>& shown() const { return shown_; }
  const PaneHeader& header(std::size_t pane) const { return *headers_[pane]; }
  TechniquePicture& picture(std::size_t pane) { return *pictures_[pane]; }
  WipeHandle& wipe() { return *wipe_; }
  // Every picture shows what the live view shows.
  bool upToDate() const;

 signals:
  void failed(const QString& message);

 private:
  struct Drawn {
    PictureSubject subject;
    std::shared_ptr<const Technique> technique;
    QImage picture;
    QString problem;  // why there is none
  };

  ComparisonMode mode() const;
  void makePanes();
  void arrange();
  void arrangeGrid();
  void takeApart();
  void refresh();
  void showErrors();
  void showPictures();
  void schedule();
  void drawNext();
  std::vector<std::string> outOfDate() const;
  bool isCurrent(const std::string& id) const;
  Drawn drawingOf(const std::string& id);
  PictureSubject subject() const;
  const std::shared_ptr<const Technique>& techniqueOf(const std::string& id) const;

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  QGridLayout* grid_;
  WipeHandle* wipe_;
  std::vector<PaneHeader*> headers_;  // as many as there can be panes
  std::vector<TechniquePicture*> pictures_;
  ComparisonMode arranged_ = ComparisonMode::Single;
  std::vector<std::string> shown_;
  std::string live_;  // the technique of the live view when the panes were arranged
  std::map<std::string, Drawn> drawn_;           // by technique
  std::unique_ptr<TechniquePictures> renderer_;  // once something is compared
  PictureSubject scheduled_;
  QTimer timer_;
};

}  // namespace umbra

// Draws the pictures of the panes beside the live view, and keeps them.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "ui/panes/ShownPanes.h"
#include "ui/picture/TechniquePictures.h"

namespace umbra {

class SceneView;

// The picture of one pane, and what is needed to probe it.
struct DrawnPane {
  PictureSubject subject;
  std::shared_ptr<const Technique> technique;
  QImage picture;
  // What the picture's frame left; null where the live view's report told what it shows.
  std::shared_ptr<const FrameSnapshot> frame;
  QString problem;  // why there is no picture
};

// The pictures follow the live view: at once in a wipe, whose halves have to fit together, else
// when the view rests. One is drawn at a time, so that what a person does meanwhile comes first.
class PanePictures : public QObject {
  Q_OBJECT

 public:
  using Picture = std::shared_ptr<const DrawnPane>;

  // `shown` is read at every call, and must live as long.
  PanePictures(const ShownPanes& shown, const SessionController& controller, SceneView& view,
               QObject* parent = nullptr);
  ~PanePictures() override;

  // The picture of exactly what the pane shows now; null until it is drawn.
  Picture current(std::size_t pane) const;
  // The current picture, and until it is drawn an earlier one: from before the camera or the light
  // moved, else what the pane showed last of its technique; null where there is none.
  Picture latest(std::size_t pane);
  // Every pane but the active one has its current picture.
  bool upToDate() const;

 public slots:
  // Has what is out of date drawn, one picture after the other.
  void schedule();

 signals:
  void drawn();
  void failed(const QString& message);

 private:
  void drawNext();
  Picture draw(std::size_t pane);
  void keep(const Picture& picture);
  std::vector<std::size_t> outOfDate() const;
  PictureSubject subject(std::size_t pane) const;
  bool needsFrame(std::size_t pane) const;

  const ShownPanes& shown_;
  const SessionController& controller_;
  SceneView& view_;
  std::vector<Picture> recent_;                  // the newest first
  std::vector<Picture> latest_;                  // by pane: what it showed last
  std::unique_ptr<TechniquePictures> renderer_;  // made with the first picture
  std::vector<PictureSubject> scheduled_;
  QTimer timer_;
};

}  // namespace umbra

// What is drawn over the picture: the probe's patch, its ray, the sun, the figures beside it.
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>
#include <optional>

#include "ui/picture/LightHandle.h"
#include "ui/picture/ProbeMarks.h"
#include "ui/picture/ProbeReport.h"
#include "ui/picture/SceneProjection.h"

namespace umbra {

// Lies over the scene's widget and lets every event through.
class SceneOverlay : public QWidget {
  Q_OBJECT

 public:
  explicit SceneOverlay(QWidget* parent);

  struct Contents {
    SceneProjection projection;
    Light light;
    std::optional<ProbeReport> report;
    QString heading, verdict;      // the two lines beside the probe; empty leaves them out
    bool wrong = false;            // the verdict is an error
    std::vector<ProbeMark> marks;  // of the saved probes
    QString hint;                  // one sentence at the bottom; empty for none
    QPolygonF selection;           // a closed outline, widget points; empty for none
    // Beneath all this, another picture from `curtainAt` (0 … 1) of the width on to the right, or
    // to the left, or what is said in its place.
    QImage curtain;
    QString curtainText;
    double curtainAt = 1.0;
    bool curtainLeft = false;
    bool framed = false;  // the active one of several panes
  };
  void setContents(Contents contents);
  const LightHandle& handle() const { return handle_; }
  // The handle is under the pointer or in the hand.
  void setHandleHot(bool hot);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawCurtain(QPainter& painter) const;
  void drawSelection(QPainter& painter) const;
  void drawRay(QPainter& painter) const;
  void drawPatch(QPainter& painter) const;
  void drawSun(QPainter& painter) const;
  std::optional<QRectF> figuresPlace() const;
  void drawFigures(QPainter& painter) const;
  void drawSaved(QPainter& painter) const;
  void drawHint(QPainter& painter) const;
  void drawFrame(QPainter& painter) const;

  Contents contents_;
  LightHandle handle_;
  bool hot_ = false;
};

}  // namespace umbra

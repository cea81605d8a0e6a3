// A pane whose technique is not the session's: its picture, with the probe over it.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include "datasets/session/Session.h"
#include "ui/picture/SceneOverlay.h"

namespace umbra {

class TechniquePicture : public QWidget {
  Q_OBJECT

 public:
  explicit TechniquePicture(QWidget* parent = nullptr);

  // What the pane shows, with the scene's overlay as it was when the picture was drawn.
  void setPicture(const QImage& picture);
  void setContents(SceneOverlay::Contents contents);
  // Why there is no picture.
  void setMessage(const QString& message);
  const QImage& picture() const { return picture_; }
  const QString& message() const { return message_; }

 signals:
  void chosen();                            // by a click
  void hovered(const umbra::Pixel& pixel);  // of the picture

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QImage picture_;
  QString message_;
  SceneOverlay* overlay_;
};

}  // namespace umbra

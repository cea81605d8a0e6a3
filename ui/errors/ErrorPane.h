// The frame's error as a picture and as numbers, part by part.
#pragma once

#include <QPoint>
#include <memory>
#include <optional>

#include "ui/errors/ErrorController.h"
#include "ui/widgets/base/Card.h"

class QBoxLayout;
class QLabel;
class QToolButton;

namespace umbra {

class ColourBar;
class ElidedLabel;
class ErrorTable;
class PictureCanvas;
class Prober;

class ErrorPane : public Card {
  Q_OBJECT

 public:
  ErrorPane(ErrorController& errors, Prober& prober, QWidget* parent = nullptr);

  PictureCanvas& canvas() { return *canvas_; }
  ErrorTable& table() { return *table_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QToolButton* addButton(const QString& text, const char* name, const QString& toolTip);
  void refresh();
  void refreshPicture();
  void refreshFigures();
  void refreshNote();
  void refreshMark();
  void showReadout();
  void showLegend();

  ErrorController& errors_;
  Prober& prober_;
  QToolButton *worst_, *clear_, *copy_;
  QBoxLayout* halves_;
  PictureCanvas* canvas_;
  ColourBar* legend_;
  ErrorTable* table_;
  ElidedLabel* grid_;  // says which pixels count
  QLabel* readout_;    // of the pixel under the pointer; else what one can do
  // The figures that the picture shows; it is painted anew only where others take their place.
  std::shared_ptr<const ErrorController::Taken> painted_;
  std::optional<ErrorPart> paintedPart_;
  double range_ = 1.0;
  std::optional<QPoint> hovered_;  // pixel of the picture
};

}  // namespace umbra

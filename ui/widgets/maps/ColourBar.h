// A horizontal scalar bar with ticks: what the colours of a picture mean.
#pragma once

#include <QWidget>

#include "filters/core/settings/FrameSettings.h"
#include "ui/widgets/maps/ColourMap.h"

namespace umbra {

class ColourBar : public QWidget {
  Q_OBJECT

 public:
  explicit ColourBar(QWidget* parent = nullptr);

  void setLabel(const QString& label);
  const QString& label() const { return label_; }
  void setScale(ColourMap map, double low, double high, const QString& label);
  // The bar of what the settings' view shows: visibility grey 0 … 1, error diverging over the range
  // that is set, depth 0 … 1, one field for each of the cascades. Hides itself for views whose
  // colours are no scale.
  void setView(const FrameSettings& settings);
  // Shows a sentence in place of a scale.
  void setNotice(const QString& text);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintCascades(QPainter& painter, const QRect& bar);

  int cascades_ = 0;     // of their fields; 0 shows a scale
  bool notice_ = false;  // the label alone
  ColourMap map_ = ColourMap::Grey;
  double low_ = 0.0, high_ = 1.0;
  QString label_;
};

}  // namespace umbra

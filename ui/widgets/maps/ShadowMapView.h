// The shadow map beside the scene: depth or any channel, with a legend and the probed region.
#pragma once

#include <QPoint>
#include <QStringList>
#include <optional>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "ui/widgets/base/Card.h"

class QComboBox;
class QToolButton;

namespace umbra {

class ColourBar;
class ShadowMapCanvas;

class ShadowMapView : public Card {
  Q_OBJECT

 public:
  explicit ShadowMapView(QWidget* parent = nullptr);

  // What the channel box offers, and which of them is shown; emits nothing.
  void setChannels(const QStringList& names, const QString& current);
  QString currentChannel() const;

  // Channel `channel` of `values` (interleaved). The colours span its finite values; the zoom
  // stays where the map's size does.
  void setImage(Image<float> values, int channel = 0);
  void setImage(const DepthMap& depth);  // the first sample of every texel
  // What the first texel is called in a read-out; 0,0 where nothing was said.
  void setOrigin(const QPoint& origin) { origin_ = origin; }
  void clear();  // no map: a hint stands in its place

  // Outlined, its centre texel marked; nothing zooms by itself.
  void setRegion(const Region& region);
  void clearRegion();

  // Zooms so that the region fills about two thirds of the view.
  void showRegion();
  void fit();

  ShadowMapCanvas* canvas() { return canvas_; }

 signals:
  // The owner answers with setImage.
  void channelChosen(const QString& name);
  void texelHovered(int x, int y);
  void texelClicked(int x, int y);

 private:
  void showReadout(int x, int y);
  void showLegend();

  QComboBox* channels_;
  QComboBox* colours_;
  QToolButton* regionButton_;
  ShadowMapCanvas* canvas_;
  ColourBar* legend_;
  QPoint origin_;
};

}  // namespace umbra

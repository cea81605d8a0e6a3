#include "ui/widgets/maps/ShadowMapView.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/ShadowMapCanvas.h"

namespace umbra {
namespace {

QToolButton* footButton(const QString& text, const QString& toolTip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(toolTip);
  button->setAutoRaise(true);
  return button;
}

}  // namespace

ShadowMapView::ShadowMapView(QWidget* parent)
    : Card(tr("Shadow map"), parent),
      channels_(new QComboBox),
      colours_(new QComboBox),
      regionButton_(footButton(tr("Region"), tr("Zoom to the probed region"))),
      canvas_(new ShadowMapCanvas),
      legend_(new ColourBar) {
  auto* fitButton = footButton(tr("Fit"), tr("Show the whole map (double click)"));
  channels_->setToolTip(tr("What is shown: depth, or a channel of the technique"));
  channels_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  addToHeader(channels_);

  colours_->addItem(tr("viridis"), int(ColourMap::Viridis));
  colours_->addItem(tr("grey"), int(ColourMap::Grey));
  colours_->setToolTip(tr("Colour map"));
  regionButton_->setEnabled(false);

  auto* foot = new QHBoxLayout;
  foot->addWidget(regionButton_);
  foot->addWidget(fitButton);
  foot->addStretch();
  foot->addWidget(colours_);
  body()->addWidget(canvas_, 1);
  body()->addWidget(legend_);
  body()->addLayout(foot);
  showLegend();

  connect(fitButton, &QToolButton::clicked, this, &ShadowMapView::fit);
  connect(regionButton_, &QToolButton::clicked, this, &ShadowMapView::showRegion);
  connect(channels_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit channelChosen(channels_->currentText()); });
  connect(colours_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    canvas_->setColourMap(ColourMap(colours_->currentData().toInt()));
    showLegend();
  });
  connect(canvas_, &ShadowMapCanvas::texelHovered, this, &ShadowMapView::showReadout);
  connect(canvas_, &ShadowMapCanvas::texelHovered, this, &ShadowMapView::texelHovered);
  connect(canvas_, &ShadowMapCanvas::texelClicked, this, &ShadowMapView::texelClicked);
  connect(canvas_, &ShadowMapCanvas::left, this, &ShadowMapView::showLegend);
}

void ShadowMapView::setChannels(const QStringList& names, const QString& current) {
  const QSignalBlocker quiet(channels_);
  channels_->clear();
  channels_->addItems(names);
  channels_->setCurrentIndex(int(names.indexOf(current)));
  showLegend();
}

QString ShadowMapView::currentChannel() const {
  return channels_->currentText();
}

void ShadowMapView::setImage(Image<float> values, int channel) {
  if (values.channels() == 1) {
    canvas_->setValues(std::move(values));
  } else {
    Image<float> one(values.width(), values.height());
    const std::size_t step = std::size_t(values.channels());
    for (std::size_t i = 0; i < one.values().size(); ++i)
      one.values()[i] = values.values()[i * step + std::size_t(channel)];
    canvas_->setValues(std::move(one));
  }
  showLegend();
}

void ShadowMapView::setImage(const DepthMap& depth) {
  Image<float> values(depth.width(), depth.height());
  for (std::size_t i = 0; i < values.values().size(); ++i)
    values.values()[i] = float(depth.values()[i * std::size_t(depth.channels())]);
  setImage(std::move(values));
}

void ShadowMapView::clear() {
  canvas_->setValues({});
  clearRegion();
  showLegend();
}

void ShadowMapView::setRegion(const Region& region) {
  canvas_->setRegion(region);
  regionButton_->setEnabled(true);
}

void ShadowMapView::clearRegion() {
  canvas_->setRegion(std::nullopt);
  regionButton_->setEnabled(false);
}

void ShadowMapView::showRegion() {
  canvas_->showRegion();
}
void ShadowMapView::fit() {
  canvas_->fit();
}

void ShadowMapView::showReadout(int x, int y) {
  showLegend();
  legend_->setLabel(tr("texel %1, %2 · %3")
                        .arg(x + origin_.x())
                        .arg(y + origin_.y())
                        .arg(style::figure(double(canvas_->valueAt({x, y})))));
}

void ShadowMapView::showLegend() {
  legend_->setVisible(!canvas_->empty());
  legend_->setScale(canvas_->colourMap(), canvas_->low(), canvas_->high(),
                    currentChannel().isEmpty() ? tr("depth") : currentChannel());
}

}  // namespace umbra

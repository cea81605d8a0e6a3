#include "ui/layers/LayersPane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <cmath>

#include "analysis/plots/SplitPlots.h"
#include "filters/gpu/ViewColours.h"
#include "ui/layers/LayersController.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/ElidedLabel.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/plots/PlotPane.h"

namespace umbra {
namespace {

constexpr int plotsBesideWidth = 640;  // logical pixels from which the plots stand side by side

std::vector<std::string> layerTints() {
  std::vector<std::string> tints;
  for (const ViewColour& colour : layerColours)
    tints.push_back(QColor::fromRgbF(double(colour[0]), double(colour[1]), double(colour[2]))
                        .name()
                        .toStdString());
  return tints;
}

}  // namespace

LayersPane::LayersPane(LayersController& layers, SessionController& controller, QWidget* parent)
    : QWidget(parent),
      layers_(layers),
      controller_(controller),
      histogram_(new PlotPane),
      cost_(new PlotPane),
      plots_(new QVBoxLayout),
      buttons_(new QHBoxLayout),
      progress_(new ElidedLabel) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addLayout(plots_, 1);
  layout->addLayout(buttons_);
  layout->addWidget(progress_);
  plots_->setSpacing(6);
  plots_->addWidget(histogram_);
  plots_->addWidget(cost_);
  buttons_->setSpacing(4);
  start_ = addButton(tr("Uniform"), "lloydStart", tr("Start with uniform splits"));
  step_ = addButton(tr("Step"), "lloydStep",
                    tr("One of Lloyd's iterations: every split moves to the weighted mean of the "
                       "second occluders nearest to it"));
  play_ = addButton(tr("Play"), "lloydPlay", tr("Iteration after iteration"));
  end_ = addButton(tr("To the end"), "lloydEnd", tr("Until no split moves"));
  progress_->setFont(style::figures(progress_->font()));
  progress_->setObjectName("lloydProgress");
  connect(histogram_, &PlotPane::markerDragged, &layers_, &LayersController::dragSplit);
  connect(histogram_, &PlotPane::markerDragFinished, &layers_, &LayersController::endDrag);
  for (PlotPane* plot : {histogram_, cost_}) {
    plot->setMinimumSize(160, 80);
    connect(plot, &PlotPane::message, this, &LayersPane::message);
  }
  connect(start_, &QPushButton::clicked, &layers_, &LayersController::startUniform);
  connect(step_, &QPushButton::clicked, &layers_, &LayersController::step);
  connect(play_, &QPushButton::clicked, &layers_,
          [this] { layers_.setPlaying(!layers_.playing()); });
  connect(end_, &QPushButton::clicked, &layers_, &LayersController::toEnd);
  connect(&layers_, &LayersController::changed, this, &LayersPane::refresh);
  refresh();
}

QPushButton* LayersPane::addButton(const QString& text, const char* name, const QString& toolTip) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(toolTip);
  buttons_->addWidget(button);
  return button;
}

void LayersPane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool beside = event->size().width() >= plotsBesideWidth;
  plots_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  // On a projector the plots stand one above the other, both as low as their axes allow.
  plots_->setStretch(0, beside ? 3 : 1);
  plots_->setStretch(1, beside ? 2 : 1);
}

void LayersPane::refresh() {
  const bool relaxes = layers_.run() != nullptr;
  start_->setEnabled(relaxes);
  step_->setEnabled(layers_.canStep());
  play_->setEnabled(layers_.playing() || layers_.canStep());
  play_->setText(layers_.playing() ? tr("Pause") : tr("Play"));
  end_->setEnabled(layers_.canStep());
  cost_->setVisible(layers_.layered());
  progress_->setText(progressText());
  if (layers_.layered() && layers_.occluders())
    refreshPlots();
  else
    showHints();
}

void LayersPane::refreshPlots() {
  const Layering layers = *layers_.layering();
  const std::vector<double> splits(layers.bounds.begin() + 1, layers.bounds.begin() + layers.count);
  histogram_->setPlot(
      layersPlot(layers_.occluders()->histogram, splits, layers.overlap, layerTints()));
  if (const LloydRun* run = layers_.run()) {
    std::vector<double> costs = run->costs();
    costs.resize(layers_.reached() + 1);
    cost_->setPlot(costPlot(costs, layers_.uniformCost(), layers_.shown()));
    return;
  }
  cost_->setTitle(tr("Cost of the splits"));
  cost_->clear(splits.empty() ? tr("One layer has no split to place.")
                              : tr("No two depths meet in this map: nothing pulls at a split."));
}

void LayersPane::showHints() {
  histogram_->setTitle(tr("Second occluders of the map"));
  cost_->setTitle(tr("Cost of the splits"));
  cost_->clear({});
  if (layers_.layered()) return histogram_->clear(tr("Looking for the map's second occluders …"));
  QStringList layered;
  for (const auto& technique : controller_.techniques())
    if (technique->info().layered()) layered << style::text(technique->info().title);
  histogram_->clear(
      tr("%1 has no layers. These techniques have:\n%2")
          .arg(style::text(controller_.technique().info().title), layered.join("\n")));
}

QString LayersPane::progressText() const {
  const LloydRun* run = layers_.run();
  if (!run) return {};
  const LloydFrame& now = run->frames()[layers_.shown()];
  QString text = tr("Iteration %1 · cost %2").arg(layers_.shown()).arg(style::figure(now.cost));
  if (layers_.uniformCost() > 0.0)
    text +=
        tr(" = %1 % of uniform").arg(int(std::lround(100.0 * now.cost / layers_.uniformCost())));
  if (now.teleports > 0) text += tr(" · %n teleport(s)", nullptr, now.teleports);
  if (!layers_.canStep()) text += tr(" · nothing moves any more");
  return text;
}

}  // namespace umbra

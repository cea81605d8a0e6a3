#include "ui/probe/ReductionTools.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <exception>

#include "analysis/frame/AdaptedTechnique.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

// Upwards, to what the form shows: a little more than the smallest also removes what the rounding
// of the GPU leaves.
double roundedUp(double amount, double largest) {
  return std::min(std::ceil(amount * 1e4 - 1e-6) * 1e-4, largest);
}

QString share(double value) {
  return QString::number(value, 'f', 3);
}

}  // namespace

ReductionTools::ReductionTools(SessionController& controller, Prober& prober, SceneView& view,
                               QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      prober_(prober),
      view_(view),
      region_(new QPushButton(tr("Smallest a for this region"))),
      frame_(new QPushButton(tr("Smallest a for the picture"))),
      said_(new QLabel) {
  region_->setObjectName("reduceRegion");
  frame_->setObjectName("reduceFrame");
  region_->setToolTip(tr("a = (p − v_ref)/(1 − v_ref), where p is the bound without reduction"));
  frame_->setToolTip(tr("The largest bound on any pixel in full shadow"));
  said_->setWordWrap(true);
  said_->setMinimumWidth(0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 2, 0, 2);
  layout->setSpacing(4);
  for (QWidget* widget : std::initializer_list<QWidget*>{region_, frame_, said_})
    layout->addWidget(widget);
  connect(region_, &QPushButton::clicked, this, &ReductionTools::findForRegion);
  connect(frame_, &QPushButton::clicked, this, &ReductionTools::findForFrame);
  refresh();
}

QString ReductionTools::said() const {
  return said_->text();
}

void ReductionTools::refresh() {
  const Technique& technique = controller_.technique();
  const bool possible = largestBleedReduction(technique).has_value() &&
                        !controller_.refusals().contains(style::text(technique.info().id));
  setVisible(possible);
  followProbe();
  const Content& content = controller_.document().content;
  frame_->setText(content.depth ? tr("Smallest a for the map") : tr("Smallest a for the picture"));
  if (taking_) return;
  said_->clear();
  said_->hide();
}

void ReductionTools::followProbe() {
  region_->setEnabled(prober_.report().has_value());
}

void ReductionTools::findForRegion() {
  const auto& report = prober_.report();
  const TechniqueResult* result =
      report ? resultOf(report->probe, controller_.session().technique) : nullptr;
  if (!result) return;
  if (const auto found = bleedReductionOf(report->probe, *result))
    take(*found, tr("removes all bleeding here; it darkens this region's penumbrae by up to %1"),
         tr("here"));
}

void ReductionTools::findForFrame() {
  try {
    take(measureFrame(),
         tr("leaves no light in any full shadow; it darkens penumbrae by up to %1, %2 on average"),
         tr("in full shadow"));
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
  }
}

BleedReduction ReductionTools::measureFrame() const {
  const Document& document = controller_.document();
  const FrameSettings& frame = document.session.frame;
  const Technique& technique = controller_.technique();
  if (const DepthMap* map = document.content.depth.get())
    return *bleedReductionOnMap(*map, *adaptedTechnique(technique, *map), frame.kernel,
                                frame.map.format,
                                document.session.receiver.value_or(NamedProbe::depthOnFile));
  return *bleedReductionOfFrame(technique, [this](const Technique& bound) {
    const auto [surfaces, reference] = view_.measure(bound);
    return boundSamplesOf(surfaces, reference);
  });
}

void ReductionTools::take(const BleedReduction& found, const QString& removes,
                          const QString& place) {
  const double largest = *largestBleedReduction(controller_.technique());
  const double amount = roundedUp(found.amount, largest);
  QString text;
  taking_ = true;
  if (!found.removesAll) {
    text = tr("Not even a = %1 removes the bleeding %2: where the bound is 1 nothing is cut off.")
               .arg(largest)
               .arg(place);
  } else {
    emit amountFound(amount);
    QString cost = removes;
    cost.replace("%1", share(found.darkening)).replace("%2", share(found.meanDarkening));
    text = amount > 0.0 ? tr("a = %1 ").arg(amount) + cost + "."
                        : tr("No light bleeds %1: a = 0.").arg(place);
  }
  taking_ = false;
  said_->setText(text);
  said_->show();
}

}  // namespace umbra

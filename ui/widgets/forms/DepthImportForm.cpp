#include "ui/widgets/forms/DepthImportForm.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/Controls.h"
#include "ui/widgets/forms/NumberField.h"

namespace umbra {
namespace {

using Projection = DepthProjection::Kind;

// Fields and the words between them in one row of a form.
QHBoxLayout* inOneRow(const std::vector<QWidget*>& parts) {
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  for (QWidget* part : parts) row->addWidget(part, qobject_cast<QLabel*>(part) ? 0 : 1);
  return row;
}

std::optional<double> whereGiven(double number) {
  return number > 0.0 ? std::optional(number) : std::nullopt;
}

}  // namespace

DepthImportForm::DepthImportForm(QWidget* parent)
    : QWidget(parent),
      rows_(new QFormLayout(this)),
      channel_(new QComboBox),
      projection_(new QComboBox),
      miss_(new QComboBox),
      atZero_(new NumberField),
      atOne_(new NumberField),
      near_(new NumberField),
      far_(new NumberField),
      angle_(new NumberField),
      missValue_(new NumberField) {
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  setStyleSheet(style::sheet());
  makeRows();
  for (NumberField* field : {atZero_, atOne_, near_, far_, angle_, missValue_})
    connect(field, &NumberField::numberEdited, this, &DepthImportForm::edited);
  for (QComboBox* box : {channel_, projection_, miss_}) {
    ignoreWheelWithoutFocus(box);
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this] {
      if (channel_->currentIndex() >= 0) wantedChannel_ = channel_->currentText();
      showWhatApplies();
      emit edited();
    });
  }
  setImport({});
}

void DepthImportForm::makeRows() {
  channel_->setObjectName("channel");
  projection_->setObjectName("projection");
  miss_->setObjectName("miss");
  atZero_->setObjectName("atZero");
  atOne_->setObjectName("atOne");
  near_->setObjectName("near");
  far_->setObjectName("far");
  angle_->setObjectName("angle");
  missValue_->setObjectName("missValue");

  rows_->addRow(tr("Channel"), channel_);
  atZero_->setToolTip(
      tr("The file's value of window depth 0: of the near plane, but where a "
         "reversed projection drew it"));
  atOne_->setToolTip(
      tr("The file's value of window depth 1. Where nearer values are larger, it is "
         "the smaller one"));
  rows_->addRow(tr("Depth 0 is"), inOneRow({atZero_, new QLabel(tr("and 1 is")), atOne_}));

  const auto add = [this](const QString& name, Projection kind, const QString& tip) {
    projection_->addItem(name, int(kind));
    projection_->setItemData(projection_->count() - 1, tip, Qt::ToolTipRole);
  };
  add(tr("linear"), Projection::Linear, tr("Values are proportional to distance"));
  add(tr("perspective"), Projection::Perspective, tr("w = f (z − n) / (z (f − n))"));
  add(tr("reversed"), Projection::Reversed, tr("w = n (f − z) / (z (f − n)): nearer is larger"));
  add(tr("infinite"), Projection::Infinite, tr("w = 1 − n / z: no far plane"));
  add(tr("reversed infinite"), Projection::ReversedInfinite, tr("w = n / z: no far plane"));
  rows_->addRow(tr("Projection"), projection_);
  near_->setToolTip(tr("The near plane's distance from the light, in world units"));
  rows_->addRow(tr("Near plane"), inOneRow({near_, new QLabel(tr("far plane")), far_}));
  angle_->setToolTip(
      tr("Degrees of the light's vertical field of view, where depths are to be distances to the "
         "light, as a spot light's techniques use, instead of to its plane"));
  angle_->setPlaceholderText(tr("angle of the light in degrees"));
  rows_->addRow(tr("Distance to light"), angle_);

  miss_->addItem(tr("are refused"), int(DepthMiss::Kind::Error));
  miss_->addItem(tr("become the nearest bound"), int(DepthMiss::Kind::Clamp));
  miss_->addItem(tr("are marked by"), int(DepthMiss::Kind::Value));
  missValue_->setPlaceholderText(tr("1e10, inf, nan"));
  missValue_->setToolTip(
      tr("The value of texels that saw nothing, which become the far bound; one within the range "
         "stands in for all that are no depths"));
  rows_->addRow(tr("Missing depths"), inOneRow({miss_, missValue_}));
}

void DepthImportForm::setChannels(const QStringList& names) {
  const QSignalBlocker quiet(channel_);
  channel_->clear();
  channel_->addItems(names);
  const bool choice = names.size() > 1;
  channel_->setVisible(choice);
  rows_->labelForField(channel_)->setVisible(choice);
  showChannel();
}

// Where none is named, it is Z or the only one.
void DepthImportForm::showChannel() {
  const QSignalBlocker quiet(channel_);
  const bool only = wantedChannel_.isEmpty() && channel_->count() == 1;
  channel_->setCurrentIndex(
      only ? 0 : channel_->findText(wantedChannel_.isEmpty() ? "Z" : wantedChannel_));
}

void DepthImportForm::setImport(const DepthImport& import) {
  wantedChannel_ = style::text(import.channel);
  showChannel();
  atZero_->setNumber(import.atZero);
  atOne_->setNumber(import.atOne);
  const DepthProjection& projection = import.projection;
  const QSignalBlocker quietProjection(projection_), quietMiss(miss_);
  projection_->setCurrentIndex(projection_->findData(int(projection.kind)));
  near_->setNumber(whereGiven(projection.near));
  far_->setNumber(whereGiven(projection.far));
  angle_->setNumber(whereGiven(projection.euclidAngle));
  miss_->setCurrentIndex(miss_->findData(int(import.miss.kind)));
  const bool valued = import.miss.kind == DepthMiss::Kind::Value;
  missValue_->setNumber(valued ? std::optional(import.miss.value) : std::nullopt);
  showWhatApplies();
}

void DepthImportForm::showWhatApplies() {
  const auto kind = Projection(projection_->currentData().toInt());
  for (NumberField* field : {near_, far_, angle_}) field->setEnabled(kind != Projection::Linear);
  const bool infinite = DepthProjection{.kind = kind}.isInfinite();
  far_->setPlaceholderText(infinite ? tr("the farthest texel") : QString());
  far_->setToolTip(infinite ? tr("Where linear depth is 1; empty: at the farthest texel")
                            : tr("The far plane's distance from the light, in world units"));
  missValue_->setVisible(DepthMiss::Kind(miss_->currentData().toInt()) == DepthMiss::Kind::Value);
}

void DepthImportForm::askForPlanes() {
  near_->setFocus();
}

bool DepthImportForm::readRange(DepthImport& import, QString& problem) const {
  const auto atZero = atZero_->number(), atOne = atOne_->number();
  if (!atZero || !atOne) {
    problem = tr("Say which values of the file are depth 0 and depth 1.");
    return false;
  }
  import.atZero = *atZero;
  import.atOne = *atOne;
  return true;
}

bool DepthImportForm::readProjection(DepthProjection& projection, QString& problem) const {
  projection.kind = Projection(projection_->currentData().toInt());
  if (projection.kind == Projection::Linear) return true;
  projection.near = near_->number().value_or(0.0);
  projection.far = far_->number().value_or(0.0);
  projection.euclidAngle = angle_->number().value_or(0.0);
  const bool farIsRight =
      projection.far > projection.near || (projection.isInfinite() && projection.far == 0.0);
  if (!far_->isRight() || !(projection.near > 0.0) || !farIsRight)
    problem = projection.isInfinite()
                  ? tr("Give the near plane, which the file does not tell: 0 < near.")
                  : tr("Give both planes, which the file does not tell: 0 < near < far.");
  else if (!angle_->isRight() || !(projection.euclidAngle >= 0.0 && projection.euclidAngle < 180.0))
    problem =
        tr("The angle of the light is between 0 and 180 degrees; leave it empty for "
           "distances to the light's plane.");
  return problem.isEmpty();
}

bool DepthImportForm::readMiss(DepthMiss& miss, QString& problem) const {
  miss.kind = DepthMiss::Kind(miss_->currentData().toInt());
  if (miss.kind != DepthMiss::Kind::Value) return true;
  const auto value = missValue_->number();
  if (!value) problem = tr("Name the value of texels that saw nothing, such as 1e10, inf or nan.");
  miss.value = value.value_or(0.0);
  return value.has_value();
}

std::optional<DepthImport> DepthImportForm::import(QString* problem) const {
  DepthImport import;
  import.channel = wantedChannel_.toStdString();
  QString why;
  const bool right = readRange(import, why) && readProjection(import.projection, why) &&
                     readMiss(import.miss, why);
  if (problem) *problem = why;
  return right ? std::optional(import) : std::nullopt;
}

}  // namespace umbra

#include "ui/widgets/FrameSettingsForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/widgets/Controls.h"
#include "ui/widgets/Style.h"

namespace umbra {

struct FrameSettingsForm::Controls {
  QComboBox *kernel, *read, *size, *format;
  NumberControl *radius, *constant, *slope;
  RealBox* sigma;
  QWidget* sigmaRow;
  QCheckBox *receiverPlane, *cullFront;
  QLabel* gpu;
};

namespace {

// A label at the left, the editor at the right end.
QWidget* row(QVBoxLayout* body, const QString& text, QWidget* editor, const QString& toolTip) {
  auto* holder = new QWidget;
  auto* line = new QHBoxLayout(holder);
  line->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(text);
  label->setMinimumWidth(0);
  line->addWidget(label, 1);
  line->addWidget(editor);
  holder->setToolTip(toolTip);
  body->addWidget(holder);
  return holder;
}

NumberControl* sliderRow(QVBoxLayout* body, QWidget* parent, const QString& text,
                         const SliderScale& scale, const QString& unit, const QString& toolTip) {
  auto* control = new NumberControl(scale, unit, parent);
  row(body, text, control->box(), toolTip);
  control->slider()->setToolTip(toolTip);
  body->addWidget(control->slider());
  return control;
}

QComboBox* choices(std::initializer_list<std::pair<QString, int>> items) {
  auto* box = new QComboBox;
  for (const auto& [text, value] : items) box->addItem(text, value);
  ignoreWheelWithoutFocus(box);
  return box;
}

void select(QComboBox* box, int value, const QString& textWhereAbsent) {
  if (box->findData(value) < 0) box->addItem(textWhereAbsent, value);
  box->setCurrentIndex(box->findData(value));
}

QString squared(int size) {
  return QString::number(size) + QChar(0xb2);
}

}  // namespace

FrameSettingsForm::FrameSettingsForm(QWidget* parent)
    : Card(tr("Filter and map"), parent), controls_(std::make_unique<Controls>()) {
  Controls& c = *controls_;
  c.kernel = choices({{tr("None"), int(KernelShape::None)},
                      {tr("Box"), int(KernelShape::Box)},
                      {tr("Gaussian"), int(KernelShape::Gaussian)}});
  row(body(), tr("Kernel"), c.kernel, tr("The prefilter's weights; square and separable"));
  c.radius = sliderRow(body(), this, tr("Radius r"), {0.0, Kernel::largestRadius, false, true},
                       tr("texels"), tr("The kernel has (2r+1)² taps"));
  c.sigma = new RealBox;
  c.sigma->setScale({0.0, Kernel::largestRadius});  // what the arrow keys step over
  c.sigma->setMaximum(Kernel::largestSigma);
  c.sigma->setFixedWidth(c.radius->box()->width());
  c.sigmaRow = row(body(), tr("Gaussian σ"), c.sigma,
                   tr("Standard deviation in texels; 0 is automatic: half the radius"));
  c.read =
      choices({{tr("Point"), int(ReadFilter::Point)}, {tr("Bilinear"), int(ReadFilter::Bilinear)}});
  row(body(), tr("Read"), c.read, tr("How the shaded frame reads the prefiltered channels"));
  c.size = choices({});
  for (int size = 128; size <= 4096; size *= 2) c.size->addItem(squared(size), size);
  row(body(), tr("Map"), c.size, tr("Texels of the shadow map"));
  c.format = choices({});
  // What textures on the GPU take.
  for (StorageFormat format :
       {StorageFormat::Unorm8, StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float})
    c.format->addItem(style::text(nameOf(format)), int(format));
  row(body(), tr("Storage"), c.format, tr("How a channel is stored per texel"));

  c.constant =
      sliderRow(body(), this, tr("Constant bias"), {0.0, 0.05}, QString(),
                tr("Subtracted from the receiver's depth (normalised to the light's range)"));
  c.slope = sliderRow(body(), this, tr("Slope bias"), {0.0, 8.0}, tr("texels"),
                      tr("The depth that the receiver's plane gains over so many texels is "
                         "subtracted as well"));
  c.receiverPlane = new QCheckBox(tr("Receiver-plane bias"));
  c.receiverPlane->setToolTip(
      tr("Also over half the filter's width, so that no tap of a plane blocks the plane"));
  c.cullFront = new QCheckBox(tr("Cull front faces"));
  c.cullFront->setToolTip(tr("Casters' faces towards the light leave no depth"));
  body()->addWidget(c.receiverPlane);
  body()->addWidget(c.cullFront);
  c.gpu = new QLabel;
  c.gpu->setWordWrap(true);
  c.gpu->setMinimumWidth(0);
  c.gpu->setFont(style::figures(font()));
  c.gpu->setToolTip(tr("GPU time of the last frame's passes, in milliseconds"));
  c.gpu->hide();
  body()->addWidget(c.gpu);
  body()->addStretch();

  connectControls();
  showSettings();
}

FrameSettingsForm::~FrameSettingsForm() = default;

void FrameSettingsForm::connectControls() {
  Controls& c = *controls_;
  // Called as soon as a person has chosen; every control writes its own member only, so that what
  // the form does not show stays as it was given.
  const auto chosen = [this](QComboBox* box, const QString& what, auto write) {
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box, what, write] {
      write(shown_, box->currentData().toInt());
      change(what);
      emit editingFinished(what);
    });
  };
  chosen(c.kernel, "kernel", [](FrameSettings& s, int v) { s.kernel.shape = KernelShape(v); });
  chosen(c.read, "read", [](FrameSettings& s, int v) { s.read.filter = ReadFilter(v); });
  chosen(c.size, "map size", [](FrameSettings& s, int v) { s.map.size = v; });
  chosen(c.format, "format", [](FrameSettings& s, int v) { s.map.format = StorageFormat(v); });

  const auto slid = [this](NumberControl* control, const QString& what, auto write) {
    connect(control, &NumberControl::changed, this, [this, what, write](double value) {
      write(shown_, value);
      change(what);
    });
    connect(control, &NumberControl::finished, this, [this, what] { emit editingFinished(what); });
  };
  slid(c.radius, "radius", [](FrameSettings& s, double v) { s.kernel.radius = int(v); });
  slid(c.constant, "constant bias", [](FrameSettings& s, double v) { s.bias.constant = v; });
  slid(c.slope, "slope bias", [](FrameSettings& s, double v) { s.bias.slope = v; });

  connect(c.sigma, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double v) {
    shown_.kernel.sigma = v > 0.0 ? std::max(v, Kernel::smallestSigma) : 0.0;
    change("sigma");
  });
  connect(c.sigma, &QDoubleSpinBox::editingFinished, this,
          [this] { emit editingFinished("sigma"); });

  const auto ticked = [this](QCheckBox* box, const QString& what, bool Bias::*member) {
    connect(box, &QCheckBox::clicked, this, [this, what, member](bool on) {
      shown_.bias.*member = on;
      change(what);
      emit editingFinished(what);
    });
  };
  ticked(c.receiverPlane, "receiver plane", &Bias::receiverPlane);
  ticked(c.cullFront, "front-face culling", &Bias::cullFrontFaces);
}

void FrameSettingsForm::setSettings(const FrameSettings& settings) {
  shown_ = settings;
  showSettings();
}

FrameSettings FrameSettingsForm::settings() const {
  return shown_;
}

void FrameSettingsForm::showSettings() {
  Controls& c = *controls_;
  select(c.kernel, int(shown_.kernel.shape), {});
  select(c.read, int(shown_.read.filter), {});
  select(c.size, shown_.map.size, squared(shown_.map.size));
  select(c.format, int(shown_.map.format), style::text(nameOf(shown_.map.format)));
  c.radius->setValue(shown_.kernel.radius);
  c.constant->setValue(shown_.bias.constant);
  c.slope->setValue(shown_.bias.slope);
  const bool filtered = shown_.kernel.shape != KernelShape::None;
  c.radius->slider()->setEnabled(filtered);
  c.radius->box()->setEnabled(filtered);

  const QSignalBlocker quiet(c.sigma);
  Kernel automatic = shown_.kernel;
  automatic.sigma = 0.0;
  c.sigma->setSpecialValueText(tr("auto %1").arg(style::figure(automatic.effectiveSigma())));
  if (c.sigma->value() != shown_.kernel.sigma) c.sigma->setValue(shown_.kernel.sigma);
  c.sigmaRow->setVisible(shown_.kernel.shape == KernelShape::Gaussian);
  c.receiverPlane->setChecked(shown_.bias.receiverPlane);
  c.cullFront->setChecked(shown_.bias.cullFrontFaces);
}

void FrameSettingsForm::change(const QString& what) {
  showSettings();
  emit settingsChanged(shown_, what);
}

void FrameSettingsForm::setFormatRefusals(const std::map<StorageFormat, QString>& reasons) {
  auto* items = qobject_cast<QStandardItemModel*>(controls_->format->model());
  for (int row = 0; row < items->rowCount(); ++row) {
    QStandardItem* item = items->item(row);
    const auto found = reasons.find(StorageFormat(item->data(Qt::UserRole).toInt()));
    item->setEnabled(found == reasons.end());
    item->setToolTip(found == reasons.end() ? QString() : found->second);
  }
}

void FrameSettingsForm::setGpuText(const QString& text) {
  controls_->gpu->setText(text);
  controls_->gpu->setVisible(!text.isEmpty());
}

}  // namespace umbra

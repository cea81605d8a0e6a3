#include "ui/widgets/forms/FrameSettingsForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/Controls.h"
#include "ui/widgets/forms/FormRows.h"

namespace umbra {

struct FrameSettingsForm::Controls {
  QComboBox *kernel, *read, *size, *format;
  QComboBox *anisotropy, *satSize, *satPrecision, *samples, *cascades;
  NumberControl *radius, *constant, *slope, *lambda, *seam;
  RealBox *sigma, *satDistance;
  QWidget *sigmaRow, *anisotropyRow, *satSizeRow, *satDistanceRow, *satPrecisionRow;
  QWidget *lambdaRow, *seamRow;
  QLabel* samplesNotice;
  QCheckBox *receiverPlane, *cullFront, *frozen;
};

namespace {

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
  makeRead();
  makeMap();

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
  body()->addStretch();

  connectControls();
  showSettings();
}

FrameSettingsForm::~FrameSettingsForm() = default;

void FrameSettingsForm::makeRead() {
  Controls& c = *controls_;
  c.read = choices({{tr("Point"), int(ReadFilter::Point)},
                    {tr("Bilinear"), int(ReadFilter::Bilinear)},
                    {tr("Trilinear"), int(ReadFilter::Trilinear)},
                    {tr("Anisotropic"), int(ReadFilter::Anisotropic)},
                    {tr("Summed area"), int(ReadFilter::SummedArea)}});
  row(body(), tr("Read"), c.read, tr("How the shaded frame reads the prefiltered channels"));
  c.anisotropy = choices({});
  for (int most = 1; most <= ReadSettings::largestAnisotropy; most *= 2)
    c.anisotropy->addItem(QString::fromUtf8("×%1").arg(most), most);
  ignoreWheelWithoutFocus(c.anisotropy);
  c.anisotropyRow = row(body(), tr("Anisotropy"), c.anisotropy,
                        tr("Reads along the longer axis of what a pixel covers, at most"));
  c.satSize = choices({{tr("Footprint"), int(SatSize::Footprint)},
                       {tr("Distance"), int(SatSize::Distance)},
                       {tr("Fixed"), int(SatSize::Fixed)}});
  c.satSizeRow =
      row(body(), tr("Box"), c.satSize,
          tr("What the summed area covers: what the pixel covers of the map; the "
             "kernel, wider near the camera; or the kernel. Never less than the kernel"));
  c.satDistance = new RealBox;
  c.satDistance->setScale({0.0, 100.0});  // what the arrow keys step over
  c.satDistance->setMaximum(ReadSettings::largestSatDistance);
  c.satDistance->setSpecialValueText(tr("auto"));
  c.satDistance->setFixedWidth(c.radius->box()->width());
  c.satDistanceRow = row(body(), tr("Box distance"), c.satDistance,
                         tr("From the camera, where the box is as wide as the kernel, in world "
                            "units; 0 is automatic: as far as the lit scene is wide"));
  c.satPrecision = choices({{tr("Centred float"), int(SatPrecision::Centred)},
                            {tr("Integer"), int(SatPrecision::Integer)},
                            {tr("Plain float"), int(SatPrecision::Plain)}});
  c.satPrecisionRow = row(body(), tr("Sums"), c.satPrecision,
                          tr("What the table adds up; plain floats lose digits as the map grows"));
}

void FrameSettingsForm::makeMap() {
  Controls& c = *controls_;
  c.size = choices({});
  for (int size = 128; size <= 4096; size *= 2) c.size->addItem(squared(size), size);
  row(body(), tr("Map"), c.size, tr("Texels of the shadow map"));
  c.format = choices({});
  // What textures on the GPU take.
  for (StorageFormat format :
       {StorageFormat::Unorm8, StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float})
    c.format->addItem(style::text(nameOf(format)), int(format));
  row(body(), tr("Storage"), c.format, tr("How a channel is stored per texel"));
  c.samples = choices({{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}});
  row(body(), tr("Samples"), c.samples, tr("Depths a texel, whose channels are averaged (MSAA)"));
  c.samplesNotice = new QLabel;
  c.samplesNotice->setObjectName("samples notice");
  c.samplesNotice->setWordWrap(true);
  c.samplesNotice->setMinimumWidth(0);
  c.samplesNotice->hide();
  body()->addWidget(c.samplesNotice);
  c.cascades = choices({{"1", 1}, {"2", 2}, {"3", 3}, {"4", 4}});
  row(body(), tr("Cascades"), c.cascades,
      tr("Parts of the view along its depth, each with a map of its own"));
  c.lambda = new NumberControl({0.0, 1.0}, QString(), this);
  c.lambdaRow =
      sliderGroup(body(), tr("Split λ"), c.lambda, tr("0 cuts the view evenly, 1 logarithmically"));
  c.seam = new NumberControl({0.0, CascadeSettings::largestSeam}, QString(), this);
  c.seamRow = sliderGroup(body(), tr("Seam"), c.seam,
                          tr("The last part of a cascade that goes over into the next"));
  c.frozen = new QCheckBox(tr("Freeze cascades"));
  c.frozen->setToolTip(tr("They stay where the camera is now, so that one can look at them"));
  body()->addWidget(c.frozen);
}

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
  chosen(c.anisotropy, "anisotropy", [](FrameSettings& s, int v) { s.read.anisotropy = v; });
  chosen(c.satSize, "box size", [](FrameSettings& s, int v) { s.read.satSize = SatSize(v); });
  chosen(c.satPrecision, "table precision",
         [](FrameSettings& s, int v) { s.read.satPrecision = SatPrecision(v); });
  chosen(c.samples, "samples", [](FrameSettings& s, int v) { s.map.samples = v; });
  chosen(c.cascades, "cascades", [](FrameSettings& s, int v) { s.map.cascades.count = v; });
  chosen(c.format, "format", [](FrameSettings& s, int v) { s.map.format = StorageFormat(v); });

  const auto slid = [this](NumberControl* control, const QString& what, auto write) {
    connect(control, &NumberControl::changed, this, [this, what, write](double value) {
      write(shown_, value);
      change(what);
    });
    connect(control, &NumberControl::finished, this, [this, what] { emit editingFinished(what); });
  };
  slid(c.radius, "radius", [](FrameSettings& s, double v) { s.kernel.radius = int(v); });
  slid(c.lambda, "split lambda",
       [](FrameSettings& s, double v) { s.map.cascades.splitLambda = v; });
  slid(c.seam, "cascade seam", [](FrameSettings& s, double v) { s.map.cascades.seam = v; });
  slid(c.constant, "constant bias", [](FrameSettings& s, double v) { s.bias.constant = v; });
  slid(c.slope, "slope bias", [](FrameSettings& s, double v) { s.bias.slope = v; });

  connect(c.sigma, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double v) {
    shown_.kernel.sigma = v > 0.0 ? std::max(v, Kernel::smallestSigma) : 0.0;
    change("sigma");
  });
  connect(c.sigma, &QDoubleSpinBox::editingFinished, this,
          [this] { emit editingFinished("sigma"); });

  connect(c.satDistance, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double v) {
            shown_.read.satDistance = v;
            change("box distance");
          });
  connect(c.satDistance, &QDoubleSpinBox::editingFinished, this,
          [this] { emit editingFinished("box distance"); });
  connect(c.frozen, &QCheckBox::clicked, this, [this](bool on) {
    shown_.map.cascades.frozen = on ? std::optional(camera_) : std::nullopt;
    change("frozen cascades");
    emit editingFinished("frozen cascades");
  });

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
  showRead();
  showMap();
  showObstacles();
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

void FrameSettingsForm::showRead() {
  Controls& c = *controls_;
  const ReadSettings& read = shown_.read;
  select(c.read, int(read.filter), {});
  select(c.anisotropy, read.anisotropy, QString::fromUtf8("×%1").arg(read.anisotropy));
  select(c.satSize, int(read.satSize), {});
  select(c.satPrecision, int(read.satPrecision), {});
  const QSignalBlocker quiet(c.satDistance);
  if (c.satDistance->value() != read.satDistance) c.satDistance->setValue(read.satDistance);
  const bool table = read.filter == ReadFilter::SummedArea;
  c.anisotropyRow->setVisible(read.filter == ReadFilter::Anisotropic);
  c.satSizeRow->setVisible(table);
  c.satDistanceRow->setVisible(table && read.satSize == SatSize::Distance);
  c.satPrecisionRow->setVisible(table);
}

void FrameSettingsForm::showMap() {
  Controls& c = *controls_;
  const CascadeSettings& cascades = shown_.map.cascades;
  select(c.size, shown_.map.size, squared(shown_.map.size));
  select(c.format, int(shown_.map.format), style::text(nameOf(shown_.map.format)));
  select(c.samples, shown_.map.samples, QString::number(shown_.map.samples));
  select(c.cascades, cascades.count, QString::number(cascades.count));
  c.lambda->setValue(cascades.splitLambda);
  c.seam->setValue(cascades.seam);
  c.frozen->setChecked(cascades.frozen.has_value());
  for (QWidget* widget : {c.lambdaRow, c.seamRow, static_cast<QWidget*>(c.frozen)})
    widget->setVisible(cascades.count > 1);
  const bool fewer = givenSamples_ > 0 && givenSamples_ < shown_.map.samples;
  c.samplesNotice->setText(tr("The driver gives %1").arg(givenSamples_));
  c.samplesNotice->setVisible(fewer);
}

// A choice is greyed out for what it alone brings: not for what is impossible already.
void FrameSettingsForm::showObstacles() {
  if (!obstacle_) return;
  Controls& c = *controls_;
  const QString present = obstacle_(shown_);
  const auto refuse = [&](QComboBox* box, auto write) {
    refuseItems(box, [&](int value) {
      FrameSettings changed = shown_;
      write(changed, value);
      const QString reason = obstacle_(changed);
      return reason == present ? QString() : reason;
    });
  };
  refuse(c.kernel, [](FrameSettings& s, int v) { s.kernel.shape = KernelShape(v); });
  refuse(c.read, [](FrameSettings& s, int v) { s.read.filter = ReadFilter(v); });
  refuse(c.format, [](FrameSettings& s, int v) { s.map.format = StorageFormat(v); });
  refuse(c.satPrecision, [](FrameSettings& s, int v) { s.read.satPrecision = SatPrecision(v); });
}

void FrameSettingsForm::change(const QString& what) {
  showSettings();
  emit settingsChanged(shown_, what);
}

void FrameSettingsForm::setObstacle(std::function<QString(const FrameSettings&)> obstacle) {
  obstacle_ = std::move(obstacle);
  showObstacles();
}

void FrameSettingsForm::setCamera(const Camera& camera) {
  camera_ = camera;
}

void FrameSettingsForm::setGivenSamples(int samples) {
  if (samples == givenSamples_) return;
  givenSamples_ = samples;
  showMap();
}

}  // namespace umbra

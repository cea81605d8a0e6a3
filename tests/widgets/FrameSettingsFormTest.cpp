#include "ui/widgets/FrameSettingsForm.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QTest>

#include "ui/widgets/Controls.h"

namespace umbra {
namespace {

class FrameSettingsFormTest : public testing::Test {
 protected:
  FrameSettingsFormTest() {
    form.show();
    QObject::connect(&form, &FrameSettingsForm::settingsChanged, &form,
                     [this](const FrameSettings& settings, const QString& what) {
                       changes.emplace_back(settings, what);
                     });
  }

  QComboBox* boxWith(int index) { return form.findChildren<QComboBox*>().at(index); }

  FrameSettingsForm form;
  std::vector<std::pair<FrameSettings, QString>> changes;
};

TEST_F(FrameSettingsFormTest, ShowingSettingsEmitsNothingAndKeepsThem) {
  FrameSettings settings;
  settings.kernel = {KernelShape::Gaussian, 9, 2.5};
  settings.map = {192, StorageFormat::Double};  // neither is offered
  settings.bias = {0.2, 20.0, false, true};     // beyond the sliders
  settings.view = ViewMode::Error;
  form.setSettings(settings);
  EXPECT_TRUE(changes.empty());
  EXPECT_EQ(form.settings(), settings);
}

TEST_F(FrameSettingsFormTest, RadiusSliderChangesTheRadiusOnly) {
  FrameSettings settings;
  settings.view = ViewMode::Depth;
  settings.map.size = 192;
  form.setSettings(settings);
  auto* radius = form.findChildren<QSlider*>().first();
  EXPECT_EQ(radius->maximum(), Kernel::largestRadius);
  radius->setValue(17);
  ASSERT_EQ(changes.size(), 1u);
  settings.kernel.radius = 17;
  EXPECT_EQ(changes[0].first, settings);
  EXPECT_EQ(changes[0].second, "radius");
}

TEST_F(FrameSettingsFormTest, SigmaIsAutomaticOrWithinTheKernelsRange) {
  FrameSettings settings;
  settings.kernel = {KernelShape::Gaussian, 9, 2.5};
  form.setSettings(settings);
  QDoubleSpinBox* sigma = nullptr;
  for (QDoubleSpinBox* box : form.findChildren<QDoubleSpinBox*>())
    if (box->value() == 2.5) sigma = box;
  ASSERT_NE(sigma, nullptr);
  for (const auto& [typed, taken] :
       {std::pair(0.001, Kernel::smallestSigma), std::pair(0.0, 0.0), std::pair(100.0, 100.0),
        std::pair(1e9, Kernel::largestSigma)}) {
    sigma->setValue(typed);
    EXPECT_EQ(form.settings().kernel.sigma, taken) << typed;
  }
}

TEST_F(FrameSettingsFormTest, EveryBoxNamesItsChange) {
  const char* names[] = {"kernel", "read", "map size", "format"};
  for (int i = 0; i < 4; ++i) {
    QComboBox* box = boxWith(i);
    const int key = box->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down;
    QTest::keyClick(box, Qt::Key(key));
    ASSERT_EQ(changes.size(), std::size_t(i + 1));
    EXPECT_EQ(changes.back().second, names[i]);
  }
  const FrameSettings& last = changes.back().first;
  EXPECT_EQ(last.kernel.shape, KernelShape::None);
  EXPECT_EQ(last.read.filter, ReadFilter::Point);
  EXPECT_EQ(last.map.size, 512);
  EXPECT_EQ(last.map.format, StorageFormat::Half);
}

TEST_F(FrameSettingsFormTest, ARefusedFormatSaysWhyAndIsPassedOver) {
  form.setFormatRefusals({{StorageFormat::Half, "too coarse"}});
  QComboBox* box = boxWith(3);
  const int half = box->findText("half");
  EXPECT_EQ(box->itemData(half, Qt::ToolTipRole).toString(), "too coarse");
  QTest::keyClick(box, Qt::Key_Up);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].first.map.format, StorageFormat::Unorm16);
  form.setFormatRefusals({});
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(changes.back().first.map.format, StorageFormat::Half);
}

TEST_F(FrameSettingsFormTest, AUnitIsSingularBesideOne) {
  FrameSettings settings;
  const auto text = [&](int radius) {
    settings.kernel.radius = radius;
    form.setSettings(settings);
    return form.findChildren<QDoubleSpinBox*>().first()->text();
  };
  EXPECT_EQ(text(1), "1 texel");
  EXPECT_EQ(text(2), "2 texels");
}

TEST_F(FrameSettingsFormTest, BoxesTickTheirOwnBias) {
  const QList<QCheckBox*> boxes = form.findChildren<QCheckBox*>();
  for (QCheckBox* box : boxes) box->click();
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].second, "receiver plane");
  EXPECT_FALSE(changes[0].first.bias.receiverPlane);
  EXPECT_EQ(changes[1].second, "front-face culling");
  EXPECT_TRUE(changes[1].first.bias.cullFrontFaces);
}

TEST_F(FrameSettingsFormTest, SigmaZeroIsShownAsAutomatic) {
  FrameSettings settings;
  settings.kernel = {KernelShape::Gaussian, 5, 0.0};
  form.setSettings(settings);
  QStringList texts;
  for (auto* box : form.findChildren<QDoubleSpinBox*>()) texts << box->text();
  EXPECT_TRUE(texts.contains("auto 2.5")) << texts.join(" | ").toStdString();
}

}  // namespace
}  // namespace umbra

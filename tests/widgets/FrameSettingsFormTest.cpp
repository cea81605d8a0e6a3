#include "ui/widgets/forms/FrameSettingsForm.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include "filters/core/settings/SettingsTable.h"
#include "ui/widgets/forms/Controls.h"

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

  QComboBox* boxShowing(const char* text) {
    for (QComboBox* box : form.findChildren<QComboBox*>())
      if (box->currentText() == text) return box;
    return nullptr;
  }

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

// Whatever a slider spans, its box takes what an option takes.
TEST_F(FrameSettingsFormTest, BoxesTakeTheRangesOfTheTable) {
  std::size_t boxes = 0;
  for (const auto& row : frameTable()) {
    const SettingInfo& info = row.info;
    if (info.name == "view.mode") continue;
    auto* editor = form.findChild<QWidget*>(QString::fromUtf8(info.name.data()));
    ASSERT_NE(editor, nullptr) << info.name;
    const std::string help = editor->toolTip().toStdString();
    EXPECT_NE(help.find("<b>" + std::string(info.name)), std::string::npos) << help;
    const auto* box = editor->findChild<QDoubleSpinBox*>();
    if (!box) continue;
    ++boxes;
    EXPECT_EQ(box->minimum(), info.automatic.empty() ? info.low : 0.0) << info.name;
    EXPECT_EQ(box->maximum(), info.high) << info.name;
    EXPECT_NE(help.find(rangeText(info)), std::string::npos) << help;
  }
  EXPECT_EQ(boxes, 8u);
}

TEST_F(FrameSettingsFormTest, EveryBoxNamesItsChange) {
  const std::pair<const char*, const char*> boxes[] = {{"Box", "kernel"},
                                                       {"Bilinear", "read"},
                                                       {"×8", "anisotropy"},
                                                       {"Footprint", "box size"},
                                                       {"Centred float", "table precision"},
                                                       {"1024²", "map size"},
                                                       {"float", "format"}};
  for (const auto& [shown, name] : boxes) {
    QComboBox* box = boxShowing(shown);
    ASSERT_NE(box, nullptr) << shown;
    changes.clear();
    QTest::keyClick(box, Qt::Key(box->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down));
    ASSERT_EQ(changes.size(), 1u) << name;
    EXPECT_EQ(changes.back().second, name);
  }
  const FrameSettings& last = changes.back().first;
  EXPECT_EQ(last.kernel.shape, KernelShape::None);
  EXPECT_EQ(last.read.filter, ReadFilter::Point);
  EXPECT_EQ(last.read.anisotropy, 4);
  EXPECT_EQ(last.read.satSize, SatSize::Distance);
  EXPECT_EQ(last.read.satPrecision, SatPrecision::Integer);
  EXPECT_EQ(last.map.size, 512);
  EXPECT_EQ(last.map.format, StorageFormat::Half);
}

TEST_F(FrameSettingsFormTest, OnlyRowsThatMatterAreShown) {
  FrameSettings settings;
  const auto shows = [&](const char* label) {
    form.setSettings(settings);
    for (QLabel* text : form.findChildren<QLabel*>())
      if (text->text() == label) return text->isVisibleTo(&form);
    ADD_FAILURE() << "no label " << label;
    return false;
  };
  for (const char* label : {"Anisotropy", "Box", "Box distance", "Sums", "Split λ", "Seam"})
    EXPECT_FALSE(shows(label)) << label;
  settings.read.filter = ReadFilter::Anisotropic;
  EXPECT_TRUE(shows("Anisotropy"));
  settings.read.filter = ReadFilter::SummedArea;
  EXPECT_FALSE(shows("Anisotropy"));
  EXPECT_TRUE(shows("Box"));
  EXPECT_TRUE(shows("Sums"));
  EXPECT_FALSE(shows("Box distance"));
  settings.read.satSize = SatSize::Distance;
  EXPECT_TRUE(shows("Box distance"));
  settings.map.cascades.count = 3;
  EXPECT_TRUE(shows("Split λ"));
  EXPECT_TRUE(shows("Seam"));
}

TEST_F(FrameSettingsFormTest, FreezingTakesTheCameraThatLooks) {
  FrameSettings settings;
  settings.map.cascades.count = 2;
  form.setSettings(settings);
  Camera camera;
  camera.position = {1.0, 2.0, 3.0};
  form.setCamera(camera);
  QCheckBox* freeze = nullptr;
  for (QCheckBox* box : form.findChildren<QCheckBox*>())
    if (box->text() == "Freeze cascades") freeze = box;
  ASSERT_NE(freeze, nullptr);
  freeze->click();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].second, "frozen cascades");
  EXPECT_EQ(changes[0].first.map.cascades.frozen, camera);
  freeze->click();
  EXPECT_EQ(changes[1].first.map.cascades.frozen, std::nullopt);
}

TEST_F(FrameSettingsFormTest, SaysWhenTheDriverGivesFewerSamples) {
  FrameSettings settings;
  settings.map.samples = 8;
  form.setSettings(settings);
  auto* notice = form.findChild<QLabel*>("samples notice");
  ASSERT_NE(notice, nullptr);
  EXPECT_FALSE(notice->isVisibleTo(&form));
  form.setGivenSamples(4);
  EXPECT_TRUE(notice->isVisibleTo(&form));
  EXPECT_EQ(notice->text(), "The driver gives 4");
  form.setGivenSamples(8);
  EXPECT_FALSE(notice->isVisibleTo(&form));
}

TEST_F(FrameSettingsFormTest, AnImpossibleChoiceSaysWhyAndIsPassedOver) {
  form.setObstacle([](const FrameSettings& frame) {
    return frame.map.format == StorageFormat::Half ? QString("too coarse") : QString();
  });
  QComboBox* box = boxShowing("float");
  const int half = box->findText("half");
  EXPECT_EQ(box->itemData(half, Qt::ToolTipRole).toString(), "too coarse");
  QTest::keyClick(box, Qt::Key_Up);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].first.map.format, StorageFormat::Unorm16);
  form.setObstacle([](const FrameSettings&) { return QString(); });
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(changes.back().first.map.format, StorageFormat::Half);
}

// Otherwise nothing could be chosen any more, not even what would help.
TEST_F(FrameSettingsFormTest, WhatIsImpossibleAlreadyGreysOutNothingElse) {
  FrameSettings settings;
  settings.read.filter = ReadFilter::SummedArea;
  form.setSettings(settings);
  form.setObstacle([](const FrameSettings& frame) {
    return frame.read.filter == ReadFilter::SummedArea ? QString("no table") : QString();
  });
  for (const char* shown : {"Summed area", "float", "Box"}) {
    QComboBox* box = boxShowing(shown);
    for (int item = 0; item < box->count(); ++item)
      EXPECT_EQ(box->itemData(item, Qt::ToolTipRole).toString(), "")
          << box->itemText(item).toStdString();
  }
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
  for (const char* text : {"Receiver-plane bias", "Cull front faces"})
    for (QCheckBox* box : form.findChildren<QCheckBox*>())
      if (box->text() == text) box->click();
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

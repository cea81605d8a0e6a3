#include "ui/widgets/forms/ParameterForm.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/widgets/ExampleTechnique.h"
#include "ui/widgets/forms/Controls.h"

namespace umbra {
namespace {

class ParameterFormTest : public testing::Test {
 protected:
  ParameterFormTest() {
    form.setTechnique(technique);
    form.show();
    QObject::connect(&form, &ParameterForm::parameterChanged, &form,
                     [this](const QString& name, const ParameterValue& value) {
                       names.push_back(name);
                       values.push_back(value);
                     });
  }

  template <class T>
  T* in(const char* parameter) {
    return form.findChild<QWidget*>(parameter)->findChild<T*>();
  }
  Slider* slider(const char* parameter) { return dynamic_cast<Slider*>(in<QSlider>(parameter)); }

  ExampleTechnique technique;
  ParameterForm form;
  std::vector<QString> names;
  std::vector<ParameterValue> values;
};

TEST_F(ParameterFormTest, ShowsTheTechniquesValuesAndEmitsNothing) {
  EXPECT_EQ(form.title(), "Example parameters");
  EXPECT_EQ(in<QDoubleSpinBox>("min-variance")->text(), "1e-06 depth²");
  EXPECT_EQ(in<QDoubleSpinBox>("bleed-reduction")->text(), "0.25");
  EXPECT_EQ(in<QDoubleSpinBox>("layers")->text(), "4");
  EXPECT_EQ(in<QComboBox>("mode")->currentData().toString(), "offset");
  EXPECT_EQ(in<QLineEdit>("splits")->text(), "0.25:0.5");
  EXPECT_TRUE(names.empty());
}

TEST_F(ParameterFormTest, LogarithmicSliderEmitsWhileItMoves) {
  Slider* variance = slider("min-variance");
  variance->setValue(variance->maximum() / 2);
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(names[0], "min-variance");
  EXPECT_NEAR(std::get<double>(values[0]), 1e-7, 1e-17);
  variance->setValue(variance->minimum());
  variance->setValue(variance->maximum());
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(std::get<double>(values[1]), 1e-12);
  EXPECT_EQ(std::get<double>(values[2]), 1e-2);
}

TEST_F(ParameterFormTest, WholeNumbersAreEmittedAsIntegers) {
  slider("layers")->setValue(slider("layers")->maximum());
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(std::get<int>(values[0]), 16);
}

TEST_F(ParameterFormTest, TypedValueIsEmittedExactly) {
  auto* box = in<QDoubleSpinBox>("bleed-reduction");
  box->selectAll();
  QTest::keyClicks(box, "0.123456");
  EXPECT_TRUE(values.empty()) << "a text that is half typed is no value";
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(std::get<double>(values[0]), 0.123456);
}

TEST_F(ParameterFormTest, TypedValueBeyondTheRangeIsNotEmitted) {
  auto* box = in<QDoubleSpinBox>("bleed-reduction");
  box->selectAll();
  QTest::keyClicks(box, "7");
  QTest::keyClick(box, Qt::Key_Return);
  for (const ParameterValue& value : values) EXPECT_LE(std::get<double>(value), 0.99);
}

TEST_F(ParameterFormTest, LeavingABoxUntouchedDoesNotRoundItsValue) {
  technique.values.amount = 0.1234567890123;
  form.setTechnique(technique);
  auto* box = in<QDoubleSpinBox>("bleed-reduction");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_TRUE(values.empty());
  EXPECT_EQ(box->value(), 0.1234567890123);
}

TEST_F(ParameterFormTest, ChoiceIsEmittedByName) {
  auto* box = in<QComboBox>("mode");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(names[0], "mode");
  EXPECT_EQ(std::get<std::string>(values[0]), "scale");
}

TEST_F(ParameterFormTest, ListIsEmittedWhenItIsFinished) {
  auto* line = in<QLineEdit>("splits");
  line->selectAll();
  QTest::keyClicks(line, "0.1:0.2:0.7");
  EXPECT_TRUE(values.empty());
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(std::get<std::vector<double>>(values[0]), (std::vector<double>{0.1, 0.2, 0.7}));
}

TEST_F(ParameterFormTest, WrongListIsExplainedAndNotEmitted) {
  auto* line = in<QLineEdit>("splits");
  auto* problem = form.findChild<QWidget*>("splits")->findChild<QLabel*>("problem");
  for (const char* wrong : {"0.1:1.5", "0.1:x"}) {
    line->selectAll();
    QTest::keyClicks(line, wrong);
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_TRUE(values.empty()) << wrong;
    EXPECT_TRUE(problem->isVisible()) << wrong;
    EXPECT_TRUE(problem->text().contains("splits")) << problem->text().toStdString();
  }
  line->selectAll();
  QTest::keyClicks(line, "0.5");
  EXPECT_FALSE(problem->isVisible());
}

TEST_F(ParameterFormTest, ResetAppearsWhereTheValueDiffersAndBringsTheDefaultBack) {
  auto* reset = in<QToolButton>("bleed-reduction");
  EXPECT_FALSE(reset->isVisible());
  slider("bleed-reduction")->setValue(700);
  EXPECT_TRUE(reset->isVisible());
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(std::get<double>(values.back()), 0.25);
  EXPECT_EQ(in<QDoubleSpinBox>("bleed-reduction")->value(), 0.25);
  EXPECT_FALSE(reset->isVisible());
}

TEST_F(ParameterFormTest, SameTechniqueKeepsItsRowsAndADragGoesOn) {
  Slider* amount = slider("bleed-reduction");
  amount->setSliderDown(true);
  amount->setSliderPosition(600);
  technique.values.amount = std::get<double>(values.back());
  technique.values.layers = 9;
  form.setTechnique(technique);
  EXPECT_EQ(slider("bleed-reduction"), amount);
  EXPECT_TRUE(amount->isSliderDown());
  EXPECT_EQ(amount->value(), 600);
  EXPECT_EQ(in<QDoubleSpinBox>("layers")->text(), "9");
  EXPECT_EQ(values.size(), 1u) << "showing a value must not emit";
}

TEST_F(ParameterFormTest, AnotherTechniqueReplacesTheRows) {
  form.setTechnique(ExampleTechnique("other", "Other", "#000000"));
  EXPECT_EQ(form.title(), "Other parameters");
  EXPECT_EQ(form.findChildren<QWidget*>("layers").size(), 1);
  slider("layers")->setValue(1);
  EXPECT_EQ(values.size(), 1u);
}

TEST_F(ParameterFormTest, SliderSaysWhenItIsLetGo) {
  QSignalSpy finished(&form, &ParameterForm::editingFinished);
  Slider* amount = slider("bleed-reduction");
  QTest::mousePress(amount, Qt::LeftButton, {}, QPoint(amount->width() / 2, amount->height() / 2));
  EXPECT_NEAR(amount->value(), amount->maximum() / 2, amount->maximum() / 20);
  EXPECT_EQ(finished.count(), 0);
  QTest::mouseRelease(amount, Qt::LeftButton);
  ASSERT_EQ(finished.count(), 1);
  EXPECT_EQ(finished[0][0].toString(), "bleed-reduction");
}

}  // namespace
}  // namespace umbra

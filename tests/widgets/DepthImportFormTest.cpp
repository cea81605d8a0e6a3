#include "ui/widgets/forms/DepthImportForm.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>

#include "ui/widgets/forms/NumberField.h"

namespace umbra {
namespace {

NumberField& fieldOf(DepthImportForm& form, const char* name) {
  return *form.findChild<NumberField*>(name);
}

TEST(DepthImportForm, SaysWhatItWasSetTo) {
  DepthImportForm form;
  QSignalSpy edited(&form, &DepthImportForm::edited);
  for (const char* projection :
       {"linear", "perspective:0.5,8", "reversed:0.5,8:euclid,60", "infinite:0.1",
        "infinite:0.1:7.25", "reversed-infinite:0.1:euclid,12.5"})
    for (const char* miss : {"error", "clamp", "1e10", "nan", "-inf"}) {
      DepthImport import;
      import.channel = "light.Z";
      import.atZero = 0.1 + 0.2;  // takes all 17 digits
      import.atOne = -1e-7;
      import.projection = projectionFrom(projection, "test");
      import.miss = depthMissFrom(miss, "test");
      form.setImport(import);
      QString problem;
      EXPECT_EQ(form.import(&problem), import) << projection << " " << miss;
      EXPECT_TRUE(problem.isEmpty()) << problem.toStdString();
    }
  EXPECT_EQ(edited.count(), 0);
}

TEST(DepthImportForm, SaysWhatIsMissing) {
  DepthImportForm form;
  DepthImport import;
  import.projection = projectionFrom("perspective:0.5,8", "test");
  QString problem;
  const struct {
    const char* field;
    const char* text;
    const char* part;
  } wrong[] = {{"near", "", "0 < near < far"},
               {"near", "-1", "0 < near < far"},
               {"near", "0.5x", "0 < near < far"},
               {"far", "0.25", "0 < near < far"},
               {"angle", "180", "between 0 and 180"},
               {"angle", "wide", "between 0 and 180"},
               {"atZero", "", "depth 0"},
               {"atOne", "one", "depth 0"}};
  for (const auto& each : wrong) {
    form.setImport(import);
    fieldOf(form, each.field).setText(each.text);
    EXPECT_FALSE(form.import(&problem)) << each.field << " " << each.text;
    EXPECT_TRUE(problem.contains(each.part)) << problem.toStdString();
  }
  // A projection without a far plane needs none.
  import.projection = projectionFrom("infinite:0.5", "test");
  form.setImport(import);
  EXPECT_TRUE(form.import(&problem));
  fieldOf(form, "near").setText("0");
  EXPECT_FALSE(form.import(&problem));
}

TEST(DepthImportForm, ANumberIsAnnouncedOnce) {
  DepthImportForm form;
  form.show();
  QSignalSpy edited(&form, &DepthImportForm::edited);
  NumberField& atOne = fieldOf(form, "atOne");
  atOne.setFocus();
  atOne.selectAll();
  QTest::keyClicks(&atOne, "2,5");
  EXPECT_EQ(edited.count(), 0);
  QTest::keyClick(&atOne, Qt::Key_Return);
  QTest::keyClick(&atOne, Qt::Key_Return);
  EXPECT_EQ(edited.count(), 1);
  EXPECT_EQ(form.import()->atOne, 2.5);
}

TEST(DepthImportForm, OffersChannelsWhereThereIsAChoice) {
  DepthImportForm form;
  form.show();
  auto& channel = *form.findChild<QComboBox*>("channel");
  form.setChannels({"depth"});
  EXPECT_FALSE(channel.isVisible());
  form.setChannels({"A", "Z"});
  EXPECT_TRUE(channel.isVisible());
  EXPECT_EQ(channel.currentText(), "Z");  // which is meant where none is named
  EXPECT_EQ(form.import()->channel, "");
  form.setChannels({"A", "B"});
  EXPECT_EQ(channel.currentIndex(), -1);
  channel.setFocus();
  QTest::keyClick(&channel, Qt::Key_Down);
  EXPECT_EQ(form.import()->channel, "A");
}

}  // namespace
}  // namespace umbra

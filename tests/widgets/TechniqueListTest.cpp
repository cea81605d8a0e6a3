#include "ui/widgets/forms/TechniqueList.h"

#include <gtest/gtest.h>

#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "tests/widgets/ExampleTechnique.h"

namespace umbra {
namespace {

class TechniqueListTest : public testing::Test {
 protected:
  TechniqueListTest() {
    list.setTechniques({&first, &second, &third});
    list.resize(240, 160);
    list.show();
  }

  ExampleTechnique first{"hard", "Hard"}, second{"vsm", "Variance"}, third{"csm", "Convolution"};
  TechniqueList list;
};

TEST_F(TechniqueListTest, HighlightsWithoutEmitting) {
  QSignalSpy chosen(&list, &TechniqueList::techniqueChosen);
  list.setCurrent("vsm");
  EXPECT_EQ(list.current(), "vsm");
  list.setCurrent("unknown");
  EXPECT_EQ(list.current(), "");
  EXPECT_EQ(chosen.count(), 0);
}

TEST_F(TechniqueListTest, ClickChooses) {
  QSignalSpy chosen(&list, &TechniqueList::techniqueChosen);
  auto* rows = list.findChild<QListWidget*>();
  QTest::mouseClick(rows->viewport(), Qt::LeftButton, {},
                    rows->visualItemRect(rows->item(2)).center());
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toString(), "csm");
}

TEST_F(TechniqueListTest, WhatIsRefusedSaysWhyAndCannotBeChosen) {
  list.setCurrent("vsm");
  list.setRefusals({{"csm", "csm cannot be stored"}});
  QSignalSpy chosen(&list, &TechniqueList::techniqueChosen);
  auto* rows = list.findChild<QListWidget*>();
  EXPECT_EQ(rows->item(2)->toolTip(), "csm cannot be stored");
  QTest::mouseClick(rows->viewport(), Qt::LeftButton, {},
                    rows->visualItemRect(rows->item(2)).center());
  QTest::keyClick(rows, Qt::Key_Down);
  EXPECT_EQ(chosen.count(), 0);
  EXPECT_EQ(list.current(), "vsm");
  list.setRefusals({});
  EXPECT_TRUE(rows->item(2)->toolTip().contains("Convolution"));
  QTest::keyClick(rows, Qt::Key_Down);
  EXPECT_EQ(chosen.count(), 1);
}

TEST_F(TechniqueListTest, TheEleventhHasAKeyToo) {
  EXPECT_EQ(techniqueKey(0), "0");
  EXPECT_EQ(techniqueKey(9), "9");
  EXPECT_EQ(techniqueKey(10), "M");
  EXPECT_EQ(techniqueKey(11), "");
}

TEST_F(TechniqueListTest, ShowsEveryRowAndExplainsIt) {
  auto* rows = list.findChild<QListWidget*>();
  EXPECT_TRUE(rows->viewport()->rect().contains(rows->visualItemRect(rows->item(2))));
  const QString toolTip = rows->item(1)->toolTip();
  for (const char* part : {"Variance", "Stores depth", "σ²", "Lauritzen 2008"})
    EXPECT_TRUE(toolTip.contains(part)) << part;
}

}  // namespace
}  // namespace umbra

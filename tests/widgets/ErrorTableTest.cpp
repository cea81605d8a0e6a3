#include "ui/widgets/tables/ErrorTable.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>
#include <vector>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

ErrorSums exampleSums(double bleeding, std::size_t pixels) {
  ErrorSums sums;
  sums.pixels = pixels;
  sums.means[std::size_t(ErrorPart::Bleeding)] = bleeding;
  sums.means[std::size_t(ErrorPart::Precision)] = -0.25;
  sums.error = bleeding - 0.25;
  return sums;
}

QString cell(const ErrorTable& table, int row, int column) {
  return table.item(row, column)->text();
}

TEST(ErrorTable, ShowsThePartsAndTheirSum) {
  ErrorTable table;
  EXPECT_EQ(cell(table, 0, 1), QString());
  EXPECT_EQ(table.asText(), QString());
  table.setSums("VSM", exampleSums(0.5, 12345), exampleSums(0.125, 0));
  EXPECT_EQ(cell(table, 0, 1), "+0.250");
  EXPECT_EQ(cell(table, 1, 0), "Bleeding");
  EXPECT_EQ(cell(table, 1, 1), "+0.500");
  EXPECT_EQ(cell(table, 5, 1), style::signedFigure(-0.25));
  EXPECT_EQ(cell(table, 7, 1), QString::fromUtf8("12\u202f345"));
  EXPECT_EQ(cell(table, 1, 2), QString::fromUtf8("–")) << "no pixel is inside";
  table.clearSums();
  EXPECT_EQ(cell(table, 1, 1), QString());
}

TEST(ErrorTable, EveryPartSaysWhatItIs) {
  const ErrorTable table;
  for (int row = 0; row < table.rowCount(); ++row)
    EXPECT_TRUE(table.item(row, 0)->toolTip().size() > 20) << row;
}

TEST(ErrorTable, RowsChooseParts) {
  ErrorTable table;
  std::vector<std::optional<ErrorPart>> chosen;
  QObject::connect(&table, &ErrorTable::partChosen,
                   [&](std::optional<ErrorPart> part) { chosen.push_back(part); });
  table.setPart(ErrorPart::Precision);
  EXPECT_TRUE(chosen.empty());
  EXPECT_EQ(table.currentRow(), 5);
  table.show();
  QTest::keyClick(&table, Qt::Key_Up);
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                    table.visualItemRect(table.item(0, 0)).center());
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0], ErrorPart::Reduction);
  EXPECT_EQ(chosen[1], std::nullopt);
}

TEST(ErrorTable, IsCopiedInFullPrecision) {
  ErrorTable table;
  table.setSums("VSM", exampleSums(1.0 / 3.0, 7), std::nullopt);
  QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QApplication::clipboard()->text().split('\n');
  EXPECT_EQ(lines[0], "VSM: mean signed error\tframe");
  EXPECT_EQ(lines[2].split('\t')[1].toDouble(), 1.0 / 3.0);
  EXPECT_EQ(lines[8], "Pixels\t7");
  table.setSums("VSM", exampleSums(0.5, 7), exampleSums(0.25, 3));
  EXPECT_EQ(table.asText().split('\n')[2], "Bleeding\t0.5\t0.25");
}

}  // namespace
}  // namespace umbra

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <limits>

#include "tests/widgets/ExampleProbe.h"
#include "tests/widgets/Grab.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/widgets/tables/ProbeTableModel.h"
#include "ui/widgets/tables/RegionTable.h"

namespace umbra {
namespace {

TEST(RegionTable, ShowsTheStatisticsOfTheProbe) {
  RegionTable table;
  table.setProbe(exampleProbe());
  EXPECT_EQ(table.asText(),
            "texel\t12, 8\ntexels\t121 · box 11×11\nmean\t0.4977\nσ²\t0.02328\n"
            "min, max\t0.257, 0.643\nβ\t1.653\nreceiver\t0.7800\nreference\t0.0000\n");
}

TEST(RegionTable, InfiniteBetaIsWrittenAsInfinity) {
  Probe probe = exampleProbe();
  probe.statistics.beta = std::numeric_limits<double>::infinity();
  RegionTable table;
  table.setProbe(probe);
  EXPECT_TRUE(table.asText().contains("β\t∞\n"));
}

TEST(RegionTable, ClearedTableShowsNoFigures) {
  RegionTable table;
  table.setProbe(exampleProbe());
  table.clear();
  for (const QString& line : table.asText().split('\n', Qt::SkipEmptyParts))
    EXPECT_TRUE(line.endsWith("\t–")) << line.toStdString();
}

class ProbeTableTest : public testing::Test {
 protected:
  ProbeTableTest() {
    table.resize(520, 240);
    table.show();
    table.setProbe(exampleProbe(), "vsm");
  }

  QString cell(int row, int column) {
    return table.view()->model()->index(row, column).data().toString();
  }

  ProbeTable table;
};

TEST_F(ProbeTableTest, ShowsVisibilityGpuAndSignedError) {
  using Model = ProbeTableModel;
  EXPECT_EQ(cell(1, Model::TitleColumn), "Variance (VSM)");
  EXPECT_EQ(cell(1, Model::ValueColumn), "0.226");
  EXPECT_EQ(cell(1, Model::GpuColumn), "0.226");
  EXPECT_EQ(cell(1, Model::ErrorColumn), "+0.226");
  EXPECT_EQ(cell(0, Model::GpuColumn), "");
  EXPECT_EQ(cell(0, Model::ErrorColumn), "+0.000");
  EXPECT_EQ(cell(2, Model::ErrorColumn), "−0.031");
  EXPECT_FALSE(table.view()->isColumnHidden(Model::GpuColumn));
}

TEST_F(ProbeTableTest, GpuColumnIsThereOnlyWithValues) {
  Probe probe = exampleProbe();
  probe.techniques[1].gpu.reset();
  table.setProbe(probe, "vsm");
  EXPECT_TRUE(table.view()->isColumnHidden(ProbeTableModel::GpuColumn));
}

TEST_F(ProbeTableTest, ARefusedTechniqueShowsADashAndItsReason) {
  using Model = ProbeTableModel;
  Probe probe = exampleProbe();
  probe.refused.push_back(
      {std::make_shared<ExampleTechnique>("esm", "Exponential (ESM)"), "esm cannot be stored"});
  table.setProbe(probe, "vsm");
  EXPECT_EQ(cell(4, Model::TitleColumn), "Exponential (ESM)");
  EXPECT_EQ(cell(4, Model::ValueColumn), "–");
  EXPECT_EQ(cell(4, Model::ErrorColumn), "–");
  const QModelIndex index = table.view()->model()->index(4, 0);
  EXPECT_EQ(index.data(Qt::ToolTipRole).toString(), "esm cannot be stored");
  QSignalSpy chosen(&table, &ProbeTable::techniqueChosen);
  QTest::mouseClick(table.view()->viewport(), Qt::LeftButton, {},
                    table.view()->visualRect(index).center());
  EXPECT_EQ(chosen.count(), 0);
  EXPECT_EQ(table.asText().split('\n').at(5), "Exponential (ESM)\t\t\t");
}

TEST_F(ProbeTableTest, RaysStandBelowTheTechniquesAndCannotBeChosen) {
  using Model = ProbeTableModel;
  const int last = 4;
  table.setProbe(exampleProbe(), "vsm", RayTracedRow{});
  ASSERT_EQ(table.view()->model()->rowCount(), last + 1);
  EXPECT_EQ(cell(last, Model::ValueColumn), "…");
  EXPECT_EQ(cell(last, Model::ErrorColumn), "");
  EXPECT_TRUE(table.asText().endsWith("map\t\t\t\n"));
  table.setProbe(exampleProbe(), "vsm", RayTracedRow{exampleProbe().reference + 0.25});
  EXPECT_EQ(cell(last, Model::ValueColumn), "0.250");
  EXPECT_EQ(cell(last, Model::ErrorColumn), "+0.250");
  EXPECT_TRUE(table.asText().endsWith("map\t0.25\t\t0.25\n"));
  QSignalSpy chosen(&table, &ProbeTable::techniqueChosen);
  QTest::mouseClick(table.view()->viewport(), Qt::LeftButton, {},
                    table.view()->visualRect(table.view()->model()->index(last, 0)).center());
  EXPECT_EQ(chosen.count(), 0);
}

TEST_F(ProbeTableTest, ClearedTableShowsAHint) {
  const auto hint = [this] {
    for (const QLabel* label : table.findChildren<QLabel*>())
      if (label->text().startsWith("Point at")) return label->isVisible();
    return false;
  };
  EXPECT_FALSE(hint());
  EXPECT_TRUE(table.view()->isVisible());
  table.clear();
  EXPECT_TRUE(hint());
  EXPECT_FALSE(table.view()->isVisible());
}

TEST_F(ProbeTableTest, CopiesFullPrecisionTabSeparated) {
  table.copy();
  const QString text = QGuiApplication::clipboard()->text();
  EXPECT_EQ(text, table.asText());
  EXPECT_EQ(text.split('\n').at(0), "technique\tvisibility\tgpu\terror");
  EXPECT_EQ(text.split('\n').at(2), "Variance (VSM)\t0.2264\t0.2262\t0.2264");
  EXPECT_EQ(text.split('\n').at(3), "Convolution (CSM)\t0\t\t-0.0312");
}

TEST_F(ProbeTableTest, TechniqueIsChosenByAPersonOnly) {
  QSignalSpy chosen(&table, &ProbeTable::techniqueChosen);
  table.setSelected("csm");
  table.setProbe(exampleProbe(), "pcf");
  EXPECT_EQ(chosen.count(), 0);
  const QRect row = table.view()->visualRect(table.view()->model()->index(3, 0));
  QTest::mouseClick(table.view()->viewport(), Qt::LeftButton, {}, row.center());
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toString(), "layered-power-cdf");
}

// In their format on the GPU; without textures there is nothing to count.
TEST_F(ProbeTableTest, BytesOfATexelAreThereOnlyWhereMapsAreStored) {
  using Model = ProbeTableModel;
  EXPECT_TRUE(table.view()->isColumnHidden(Model::BytesColumn));
  EXPECT_EQ(cell(1, Model::BytesColumn), "");
  table.resize(640, 240);
  table.setProbe(exampleProbe(), "vsm", {}, StorageFormat::Half);
  EXPECT_FALSE(table.view()->isColumnHidden(Model::BytesColumn));
  const std::size_t channels = exampleProbe().techniques[1].technique->channels().size();
  EXPECT_EQ(cell(1, Model::BytesColumn), QString::number(2 * channels));
  EXPECT_EQ(table.asText().split('\n').at(0), "technique\tvisibility\tgpu\terror\tbytes per texel");
  EXPECT_TRUE(table.asText().split('\n').at(2).endsWith("\t" + QString::number(2 * channels)));
  const QVariant tip = table.view()->model()->index(1, 0).data(Qt::ToolTipRole);
  EXPECT_TRUE(tip.toString().contains("2 bytes per texel")) << tip.toString().toStdString();
  table.resize(200, 240);  // the error matters more
  EXPECT_TRUE(table.view()->isColumnHidden(Model::BytesColumn));
  EXPECT_FALSE(table.view()->isColumnHidden(Model::ErrorColumn));
}

TEST_F(ProbeTableTest, BarLiesOnTheErrorsSideOfZero) {
  const Grab shown(*table.view()->viewport());
  const auto reds = [&](int row) {
    const QRect area =
        table.view()->visualRect(table.view()->model()->index(row, ProbeTableModel::BarColumn));
    std::pair<int, int> sides{0, 0};
    for (int x = area.left(); x <= area.right(); ++x) {
      if (QColor(shown(x, area.center().y())) != style::error) continue;
      ++(x < area.center().x() ? sides.first : sides.second);
    }
    return sides;
  };
  const auto bleeding = reds(1), darkening = reds(3), exact = reds(0);
  EXPECT_LE(bleeding.first, 1);
  EXPECT_GT(bleeding.second, 3);
  EXPECT_GT(darkening.first, 4 * bleeding.second - 8);  // −1 against +0.226
  EXPECT_LE(darkening.second, 1);
  EXPECT_EQ(exact.first + exact.second, 0);
}

TEST_F(ProbeTableTest, NarrowTableKeepsTitleValueAndError) {
  table.resize(260, 240);
  EXPECT_FALSE(table.view()->isColumnHidden(ProbeTableModel::ErrorColumn));
  EXPECT_LE(table.view()->horizontalHeader()->length(), table.view()->viewport()->width());
}

}  // namespace
}  // namespace umbra

#include "ui/widgets/tables/TracePane.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QTableWidget>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

Trace bleeding() {
  Trace trace;
  trace.steps = {{"μ", "mean of the region", "M1", 0.4},
                 {"σ²", "variance of the region", "M2 − μ²", 0.04},
                 {"v", "visibility", "", 0.26}};
  trace.cause = ErrorCause::DistantVariance;
  trace.culprit = 1;
  trace.sentence = "Too bright by 0.26.";
  return trace;
}

TEST(TracePane, ShowsEveryStepAndMarksTheOneThatErrs) {
  TracePane pane;
  pane.setTrace("VSM", bleeding());
  ASSERT_EQ(pane.view()->rowCount(), 3);
  EXPECT_EQ(pane.view()->item(1, 0)->text(), QString::fromUtf8("σ²"));
  EXPECT_EQ(pane.view()->item(1, 1)->text(), "0.04");
  for (int row = 0; row < 3; ++row)
    EXPECT_EQ(pane.view()->item(row, 0)->foreground().color() == style::error, row == 1);
  EXPECT_EQ(pane.sentence(), "Too bright by 0.26.");
  EXPECT_TRUE(pane.title().contains("VSM"));
}

TEST(TracePane, CopiesItsTextAndForgetsItWhenCleared) {
  TracePane pane;
  pane.setTrace("VSM", bleeding());
  pane.copy();
  const QString copied = QGuiApplication::clipboard()->text();
  EXPECT_EQ(copied, pane.asText());
  EXPECT_TRUE(copied.startsWith("VSM\nToo bright by 0.26.\n"));
  EXPECT_TRUE(copied.contains(QString::fromUtf8("→ σ²")));
  pane.clear("Nothing here.");
  EXPECT_EQ(pane.asText(), "");
  EXPECT_EQ(pane.view()->rowCount(), 0);
  EXPECT_EQ(pane.sentence(), "Nothing here.");
  pane.copy();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), copied) << "an empty pane copies nothing";
}

TEST(TracePane, AShorterTraceLeavesNoRowBehind) {
  TracePane pane;
  Trace trace = bleeding();
  pane.setTrace("VSM", trace);
  trace.steps.resize(1);
  trace.culprit.reset();
  trace.cause = ErrorCause::None;
  pane.setTrace("VSM", trace);
  ASSERT_EQ(pane.view()->rowCount(), 1);
  EXPECT_NE(pane.view()->item(0, 0)->foreground().color(), style::error);
}

}  // namespace
}  // namespace umbra

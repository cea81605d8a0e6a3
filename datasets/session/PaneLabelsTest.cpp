#include "datasets/session/PaneLabels.h"

#include <gtest/gtest.h>

#include "datasets/session/PaneEditing.h"

namespace umbra {
namespace {

using Labels = std::vector<std::string>;

Session grid(const std::vector<std::string>& techniques) {
  Session session;
  session.technique = techniques.front();
  session.comparison.mode = ComparisonMode::Grid;
  session.comparison.panes = linkedPanes(techniques);
  return session;
}

TEST(PaneLabels, PanesThatShareEverythingAreToldByTheirTechniques) {
  EXPECT_EQ(paneLabels(grid({"vsm", "lvsm", "msm"}), allTechniques()), (Labels{"", "", ""}));
}

TEST(PaneLabels, OfTwoPanesBothSayWhatDiffers) {
  Session session = grid({"vsm", "msm"});
  closePane(session, 1);
  duplicatePane(session, 0);
  session.frame.kernel.radius = 12;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"radius 3", "radius 12"}));
}

TEST(PaneLabels, WhatAFormatLimitsIsNoOtherParameter) {
  Session session = grid({"msm", "vsm"});
  duplicatePane(session, 0);
  session.frame.map.format = StorageFormat::Half;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"", "half", ""}));
}

TEST(PaneLabels, SayWhereAPaneIsNotAsMostAre) {
  Session session = grid({"vsm", "msm"});
  duplicatePane(session, 0);
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"", "", ""}));
  session.frame.kernel.radius = 12;
  session.frame.map.format = StorageFormat::Half;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"", "radius 12 · half", ""}));
  session.frame.kernel.shape = KernelShape::None;
  EXPECT_EQ(paneLabels(session, allTechniques())[1], "no prefilter · half");
}

TEST(PaneLabels, ParametersAreComparedWithinATechnique) {
  Session session = grid({"vsm", "lvsm"});
  duplicatePane(session, 0);
  setParameters(session, "vsm", {{"bleed-reduction", 0.3}});
  EXPECT_EQ(paneLabels(session, allTechniques()),
            (Labels{"bleed reduction 0", "bleed reduction 0.3", ""}));
}

TEST(PaneLabels, WhatAReadDoesNotUseIsNoDifference) {
  Session session = grid({"vsm", "msm"});
  duplicatePane(session, 0);
  session.frame.read.anisotropy = 4;
  session.frame.kernel.sigma = 2.0;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"", "", ""}));
  session.frame.read.filter = ReadFilter::SummedArea;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"", "summed area", ""}));
  duplicatePane(session, 1);
  session.frame.read.satPrecision = SatPrecision::Plain;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"bilinear", "summed area · centred sums",
                                                          "summed area · plain sums", "bilinear"}));
}

TEST(PaneLabels, OfAWipeAreItsTwoSides) {
  Session session = grid({"vsm", "msm"});
  session.comparison.mode = ComparisonMode::Wipe;
  duplicatePane(session, 0);
  session.frame.map.size = 512;
  EXPECT_EQ(paneLabels(session, allTechniques()), (Labels{"map 1024", "map 512"}));
}

}  // namespace
}  // namespace umbra

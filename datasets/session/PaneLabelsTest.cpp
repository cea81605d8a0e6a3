#include "datasets/session/PaneLabels.h"

#include <gtest/gtest.h>

#include "datasets/session/PaneEditing.h"

namespace umbra {
namespace {

using Labels = std::vector<std::string>;

Workspace grid(const std::vector<std::string>& techniques) {
  Workspace workspace;
  workspace.shared.technique = techniques.front();
  workspace.comparison.mode = ComparisonMode::Grid;
  workspace.comparison.panes = linkedPanes(techniques);
  return workspace;
}

TEST(PaneLabels, PanesThatShareEverythingAreToldByTheirTechniques) {
  EXPECT_EQ(paneLabels(grid({"vsm", "lvsm", "msm"}), allTechniques()), (Labels{"", "", ""}));
}

TEST(PaneLabels, OfTwoPanesBothSayWhatDiffers) {
  Workspace workspace = grid({"vsm", "msm"});
  closePane(workspace, 1);
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) { active.frame.kernel.radius = 12; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"radius 3", "radius 12"}));
}

TEST(PaneLabels, WhatAFormatLimitsIsNoOtherParameter) {
  Workspace workspace = grid({"msm", "vsm"});
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) { active.frame.map.format = StorageFormat::Half; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"", "half", ""}));
}

TEST(PaneLabels, SayWhereAPaneIsNotAsMostAre) {
  Workspace workspace = grid({"vsm", "msm"});
  duplicatePane(workspace, 0);
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"", "", ""}));
  editSession(workspace, [](Session& active) { active.frame.kernel.radius = 12; });
  editSession(workspace, [](Session& active) { active.frame.map.format = StorageFormat::Half; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"", "radius 12 · half", ""}));
  editSession(workspace, [](Session& active) { active.frame.kernel.shape = KernelShape::None; });
  EXPECT_EQ(paneLabels(workspace, allTechniques())[1], "no prefilter · half");
}

TEST(PaneLabels, ParametersAreComparedWithinATechnique) {
  Workspace workspace = grid({"vsm", "lvsm"});
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) {
    setParameters(active, "vsm", {{"bleed-reduction", 0.3}});
  });
  EXPECT_EQ(paneLabels(workspace, allTechniques()),
            (Labels{"bleed reduction 0", "bleed reduction 0.3", ""}));
}

TEST(PaneLabels, WhatAReadDoesNotUseIsNoDifference) {
  Workspace workspace = grid({"vsm", "msm"});
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) { active.frame.read.anisotropy = 4; });
  editSession(workspace, [](Session& active) { active.frame.kernel.sigma = 2.0; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"", "", ""}));
  editSession(workspace,
              [](Session& active) { active.frame.read.filter = ReadFilter::SummedArea; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"", "summed area", ""}));
  duplicatePane(workspace, 1);
  editSession(workspace,
              [](Session& active) { active.frame.read.satPrecision = SatPrecision::Plain; });
  EXPECT_EQ(
      paneLabels(workspace, allTechniques()),
      (Labels{"bilinear", "summed area · centred sums", "summed area · plain sums", "bilinear"}));
}

TEST(PaneLabels, OfAWipeAreItsTwoSides) {
  Workspace workspace = grid({"vsm", "msm"});
  workspace.comparison.mode = ComparisonMode::Wipe;
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) { active.frame.map.size = 512; });
  EXPECT_EQ(paneLabels(workspace, allTechniques()), (Labels{"map 1024", "map 512"}));
}

}  // namespace
}  // namespace umbra

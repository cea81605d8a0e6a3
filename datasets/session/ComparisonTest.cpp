#include "datasets/session/PaneChoice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "datasets/session/PaneEditing.h"

namespace umbra {
namespace {

using Ids = std::vector<std::string>;

// The pane of `technique` is the active one; every pane shares its settings.
Workspace comparing(ComparisonMode mode, const Ids& techniques, const char* technique) {
  Workspace workspace;
  workspace.shared.technique = technique;
  workspace.comparison.mode = mode;
  workspace.comparison.panes = linkedPanes(techniques);
  const auto place = std::find(techniques.begin(), techniques.end(), technique);
  if (place != techniques.end())
    workspace.comparison.active = std::size_t(place - techniques.begin());
  return workspace;
}

Ids idsOf(const Workspace& workspace) {
  Ids ids;
  for (const Pane& pane : comparisonOf(workspace).panes) ids.push_back(pane.technique);
  return ids;
}

std::size_t activeOf(const Workspace& workspace) {
  return comparisonOf(workspace).active;
}

int radiusOf(const Workspace& workspace, std::size_t pane) {
  return sessionOfPane(workspace, pane).frame.kernel.radius;
}

int radiusOf(const Workspace& workspace) {
  return sessionOf(workspace).frame.kernel.radius;
}

// What a person does at the controls, which are about the active pane.
void setRadius(Workspace& workspace, int radius) {
  editSession(workspace, [&](Session& active) { active.frame.kernel.radius = radius; });
}

void setReduction(Workspace& workspace, double reduction) {
  editSession(workspace, [&](Session& active) {
    setParameters(active, "vsm", {{"bleed-reduction", reduction}});
  });
}

double reductionOf(const Workspace& workspace, std::size_t pane) {
  const ParameterValues values = parametersOf(sessionOfPane(workspace, pane), "vsm");
  const auto found = values.find("bleed-reduction");
  return found == values.end() ? 0.0 : std::get<double>(found->second);
}

TEST(Comparison, TheSessionsTechniqueIsAlwaysShown) {
  EXPECT_EQ(idsOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "msm")), (Ids{"pcf", "msm"}));
  EXPECT_EQ(idsOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "esm")), (Ids{"esm", "msm"}));
  for (const char* id : {"vsm", "hard"}) {
    const Workspace workspace = comparing(ComparisonMode::Grid, {}, id);
    const Ids panes = idsOf(workspace);
    EXPECT_GE(panes.size(), Comparison::fewest);
    EXPECT_EQ(std::count(panes.begin(), panes.end(), id), 1);
    EXPECT_EQ(panes[activeOf(workspace)], id);
  }
}

TEST(Comparison, AChosenTechniqueTakesThePlaceOfTheOneThatWas) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"pcf", "msm", "vsm"}, "msm");
  chooseTechnique(workspace, "esm");
  EXPECT_EQ(workspace.shared.technique, "esm");
  EXPECT_EQ(idsOf(workspace), (Ids{"pcf", "esm", "vsm"}));
  chooseTechnique(workspace, "vsm");
  EXPECT_EQ(workspace.shared.technique, "vsm");
  EXPECT_EQ(idsOf(workspace), (Ids{"pcf", "esm", "vsm"}));
  EXPECT_EQ(activeOf(workspace), 2u);
}

TEST(Comparison, WithoutOneTheListStays) {
  Workspace workspace = comparing(ComparisonMode::Single, {"pcf", "msm"}, "msm");
  chooseTechnique(workspace, "esm");
  EXPECT_EQ(workspace.shared.technique, "esm");
  EXPECT_EQ(workspace.comparison.panes, linkedPanes({"pcf", "msm"}));
}

TEST(Comparison, AWipesOtherSideStaysUnlessItIsChosen) {
  Workspace workspace = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "evsm4", "msm"}, "vsm");
  for (const char* id : {"msm", "pcf", "evsm4", "vsm"}) {
    chooseTechnique(workspace, id);
    EXPECT_EQ(workspace.shared.technique, id);
    EXPECT_EQ(idsOf(workspace)[0], id);
    EXPECT_EQ(idsOf(workspace)[1], "lvsm") << id;
  }
  // What both sides show stays where it is; the other one becomes the active one.
  chooseTechnique(workspace, "lvsm");
  EXPECT_EQ(workspace.shared.technique, "lvsm");
  EXPECT_EQ(activeOf(workspace), 1u);
  EXPECT_EQ(idsOf(workspace)[0], "vsm");
  EXPECT_EQ(idsOf(workspace)[1], "lvsm");
}

TEST(Comparison, AWipeHasTheActivePaneOnOneOfItsSides) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "msm");
  setMode(workspace, ComparisonMode::Wipe);
  EXPECT_EQ(shownPanes(workspace.comparison), 2u);
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "msm", "lvsm"}));
  EXPECT_EQ(activeOf(workspace), 1u);
}

TEST(Comparison, SidesChangePlacesWhenOneTakesTheOthersTechnique) {
  Workspace workspace = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(workspace, 1, "vsm");
  EXPECT_EQ(idsOf(workspace), (Ids{"lvsm", "vsm", "msm"}));
  EXPECT_EQ(workspace.shared.technique, "vsm");
  EXPECT_EQ(activeOf(workspace), 1u);
  choosePane(workspace, 0, "pcf");
  EXPECT_EQ(workspace.shared.technique, "vsm");
  EXPECT_EQ(idsOf(workspace)[0], "pcf");
}

TEST(Comparison, APanesTechniqueIsExchangedAndNoneOfTheLinkedIsThereTwice) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(workspace, 1, "pcf");
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "pcf", "msm"}));
  EXPECT_EQ(workspace.shared.technique, "vsm");
  choosePane(workspace, 1, "msm");
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "msm", "pcf"}));
  choosePane(workspace, 0, "esm");
  EXPECT_EQ(idsOf(workspace), (Ids{"esm", "msm", "pcf"}));
  EXPECT_EQ(workspace.shared.technique, "esm");
  choosePane(workspace, 0, "pcf");
  EXPECT_EQ(idsOf(workspace), (Ids{"pcf", "msm", "esm"}));
  EXPECT_EQ(workspace.shared.technique, "pcf");
  EXPECT_EQ(activeOf(workspace), 0u);
}

TEST(Comparison, PanesAreAddedAndTakenAwayButNotTheActiveOne) {
  const Ids known{"hard", "pcf", "vsm", "esm", "msm", "csm"};
  Workspace workspace = comparing(ComparisonMode::Grid, {"pcf", "vsm", "msm"}, "msm");
  setPaneCount(workspace, 2, known);
  EXPECT_EQ(idsOf(workspace), (Ids{"pcf", "msm"}));
  EXPECT_EQ(activeOf(workspace), 1u);
  setPaneCount(workspace, 6, known);
  EXPECT_EQ(idsOf(workspace), (Ids{"pcf", "msm", "vsm", "lvsm", "evsm4", "hard"}));
}

TEST(Comparison, LinkedPanesFollowTheSession) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  setRadius(workspace, 9);
  EXPECT_EQ(radiusOf(workspace, 1), 9);
  activatePane(workspace, 1);
  setRadius(workspace, 4);
  EXPECT_EQ(radiusOf(workspace, 0), 4);
}

TEST(Comparison, ADuplicateIsSetByItself) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  setRadius(workspace, 3);
  duplicatePane(workspace, 0);
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "vsm", "msm"}));
  EXPECT_EQ(activeOf(workspace), 1u);
  setRadius(workspace, 12);
  setReduction(workspace, 0.3);
  EXPECT_EQ(radiusOf(workspace, 0), 3);
  EXPECT_EQ(radiusOf(workspace, 1), 12);
  EXPECT_EQ(radiusOf(workspace, 2), 3);
  EXPECT_EQ(reductionOf(workspace, 0), 0.0);
  EXPECT_EQ(reductionOf(workspace, 1), 0.3);
  // Whoever goes to another pane leaves them as they are.
  const Workspace before = workspace;
  activatePane(workspace, 2);
  EXPECT_EQ(radiusOf(workspace), 3);
  setRadius(workspace, 5);  // of the panes that share it
  EXPECT_EQ(radiusOf(workspace, 0), 5);
  EXPECT_EQ(radiusOf(workspace, 1), 12);
  setRadius(workspace, 3);
  activatePane(workspace, 1);
  EXPECT_EQ(workspace, before);
}

// Nothing changes hands: what panes share and what is a pane's own stand where they stood.
TEST(Comparison, AnotherActivePaneMovesNoSetting) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  duplicatePane(workspace, 0);
  setRadius(workspace, 12);
  setReduction(workspace, 0.3);
  const Workspace before = workspace;
  for (const std::size_t pane : {2u, 0u, 1u}) {
    activatePane(workspace, pane);
    EXPECT_EQ(workspace.comparison.panes, before.comparison.panes) << pane;
    EXPECT_EQ(workspace.shared.frame, before.shared.frame) << pane;
    EXPECT_EQ(workspace.shared.parameters, before.shared.parameters) << pane;
    setSession(workspace, sessionOf(workspace));
    EXPECT_EQ(workspace.comparison.panes, before.comparison.panes) << pane;
    EXPECT_EQ(workspace.shared.frame, before.shared.frame) << pane;
  }
  EXPECT_EQ(workspace, before);
}

TEST(Comparison, AnotherTechniqueInAPaneOfItsOwnTakesNoParametersAlong) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  duplicatePane(workspace, 0);
  setRadius(workspace, 12);
  setReduction(workspace, 0.3);
  chooseTechnique(workspace, "msm");  // in place, although a linked pane has it
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "msm", "msm"}));
  EXPECT_EQ(activeOf(workspace), 1u);
  EXPECT_EQ(radiusOf(workspace), 12);
  EXPECT_EQ(reductionOf(workspace, 0), 0.0);
  EXPECT_TRUE(parametersOf(sessionOf(workspace), "msm").empty());
  EXPECT_EQ(radiusOf(workspace, 2), 3);
}

TEST(Comparison, SettingsBecomeOwnAndSharedOneByOne) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  for (const std::size_t pane : {0u, 1u}) {
    SCOPED_TRACE(pane);
    for (int i = 0; i <= int(PaneSetting::Bias); ++i) {
      Workspace changed = workspace;
      setOwn(changed, pane, PaneSetting(i), true);
      for (int other = 0; other <= int(PaneSetting::Bias); ++other)
        EXPECT_EQ(hasOwn(changed.comparison.panes[pane], PaneSetting(other)), other == i);
      EXPECT_FALSE(changed.comparison.panes[pane].linked());
      setOwn(changed, pane, PaneSetting(i), false);
      EXPECT_EQ(changed, workspace);
    }
  }
  duplicatePane(workspace, 0);
  setRadius(workspace, 12);
  editSession(workspace, [](Session& active) { active.frame.map.format = StorageFormat::Half; });
  setOwn(workspace, 1, PaneSetting::Kernel, false);
  EXPECT_EQ(radiusOf(workspace), 3);  // as the others
  EXPECT_EQ(sessionOf(workspace).frame.map.format, StorageFormat::Half);
  setRadius(workspace, 7);
  EXPECT_EQ(radiusOf(workspace, 0), 7);
  setLinked(workspace, 1, true);
  EXPECT_TRUE(workspace.comparison.panes[1].linked());
  EXPECT_EQ(sessionOf(workspace).frame.map.format, StorageFormat::Float);
}

TEST(Comparison, APaneTakesTheActiveOnesSettings) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm", "esm"}, "vsm");
  duplicatePane(workspace, 0);  // [vsm, vsm*, msm, esm]
  setRadius(workspace, 12);
  setReduction(workspace, 0.3);
  copyActiveSettings(workspace, 2);
  EXPECT_EQ(radiusOf(workspace, 2), 12);
  EXPECT_FALSE(workspace.comparison.panes[2].own.parameters);
  copyActiveSettings(workspace, 0);
  EXPECT_EQ(reductionOf(workspace, 0), 0.3);
  EXPECT_EQ(radiusOf(workspace, 3), 3);
  activatePane(workspace, 3);
  copyActiveSettings(workspace, 1);
  EXPECT_EQ(radiusOf(workspace, 1), 3);
  EXPECT_EQ(reductionOf(workspace, 1), 0.3);  // of another technique than the active one
  copyActiveSettings(workspace, 3);           // itself
  EXPECT_TRUE(workspace.comparison.panes[3].linked());
}

TEST(Comparison, OfOnePictureADuplicateMakesTwoPanes) {
  Workspace workspace = comparing(ComparisonMode::Single, {}, "vsm");
  duplicatePane(workspace, comparisonOf(workspace).active);
  EXPECT_EQ(workspace.comparison.mode, ComparisonMode::Grid);
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "vsm"}));
  EXPECT_EQ(activeOf(workspace), 1u);
}

TEST(Comparison, InAWipeADuplicateIsTheOtherSide) {
  for (const char* technique : {"vsm", "msm"}) {
    Workspace workspace = comparing(ComparisonMode::Wipe, {"vsm", "msm", "esm"}, technique);
    duplicatePane(workspace, comparisonOf(workspace).active);
    EXPECT_EQ(shownPanes(comparisonOf(workspace)), 2u);
    EXPECT_EQ(idsOf(workspace)[0], technique);
    EXPECT_EQ(idsOf(workspace)[1], technique);
    EXPECT_EQ(activeOf(workspace), 1u);
    EXPECT_TRUE(workspace.comparison.panes[0].linked());
  }
}

TEST(Comparison, ThereAreNeverMoreThanSixPanes) {
  for (const std::size_t pane : {0u, 5u}) {
    Workspace workspace =
        comparing(ComparisonMode::Wipe, {"hard", "pcf", "vsm", "esm", "lvsm", "msm"}, "hard");
    workspace.comparison.mode = ComparisonMode::Grid;
    duplicatePane(workspace, pane);
    EXPECT_EQ(workspace.comparison.panes.size(), Comparison::most);
    EXPECT_EQ(workspace.shared.technique, pane == 0 ? "hard" : "msm");
    EXPECT_EQ(workspace.comparison.panes[activeOf(workspace) - 1].technique,
              workspace.shared.technique);
  }
}

TEST(Comparison, OnePicturesDuplicateStandsBesideWhatWasSet) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "msm");
  for (const std::size_t pane : {0u, 2u}) setOwn(workspace, pane, PaneSetting::Kernel, true);
  activatePane(workspace, 0);
  setRadius(workspace, 9);
  activatePane(workspace, 2);
  setMode(workspace, ComparisonMode::Single);
  duplicatePane(workspace, 2);
  EXPECT_EQ(workspace.comparison.mode, ComparisonMode::Grid);
  EXPECT_EQ(idsOf(workspace), (Ids{"vsm", "msm", "msm"}));
  EXPECT_EQ(activeOf(workspace), 2u);
  EXPECT_EQ(radiusOf(workspace, 0), 9);
}

TEST(Comparison, AClosedSideLeavesThePanesBehindAWipe) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm", "esm", "pcf"}, "esm");
  setOwn(workspace, 2, PaneSetting::Kernel, true);
  setRadius(workspace, 12);
  for (const std::size_t closed : {0u, 1u})
    for (const std::size_t active : {0u, 1u}) {
      Workspace wipe = workspace;
      activatePane(wipe, active);
      setMode(wipe, ComparisonMode::Wipe);
      closePane(wipe, closed);
      EXPECT_EQ(wipe.comparison.mode, ComparisonMode::Single);
      const char* const left = closed == 0 ? "msm" : "vsm";
      EXPECT_EQ(wipe.shared.technique, left);
      EXPECT_EQ(radiusOf(wipe), Kernel{}.radius);
      setMode(wipe, ComparisonMode::Grid);
      EXPECT_EQ(idsOf(wipe), (Ids{left, "esm", "pcf"}));
      EXPECT_EQ(activeOf(wipe), 0u);
      EXPECT_EQ(radiusOf(wipe, 1), 12);
    }
}

TEST(Comparison, AClosedPaneLeavesTheOthersAsTheyAre) {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  duplicatePane(workspace, 0);
  setRadius(workspace, 12);
  Workspace inactive = workspace;
  closePane(inactive, 0);
  EXPECT_EQ(idsOf(inactive), (Ids{"vsm", "msm"}));
  EXPECT_EQ(activeOf(inactive), 0u);
  EXPECT_EQ(radiusOf(inactive), 12);
  EXPECT_EQ(radiusOf(inactive, 1), 3);
  closePane(workspace, 1);
  EXPECT_EQ(workspace.shared.technique, "vsm");
  EXPECT_EQ(radiusOf(workspace), 3);
  EXPECT_TRUE(workspace.comparison.panes[0].linked());
  // The last but one: what stays is the picture, as it was.
  closePane(inactive, 1);
  EXPECT_EQ(inactive.comparison, Comparison{});
  EXPECT_EQ(radiusOf(inactive), 12);
}

}  // namespace
}  // namespace umbra

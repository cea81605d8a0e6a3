#include "datasets/session/Comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "datasets/session/PaneEditing.h"
#include "datasets/session/Session.h"

namespace umbra {
namespace {

using Ids = std::vector<std::string>;

// The pane of `technique` is the active one; every pane shares its settings.
Session comparing(ComparisonMode mode, const Ids& techniques, const char* technique) {
  Session session;
  session.technique = technique;
  session.comparison.mode = mode;
  session.comparison.panes = linkedPanes(techniques);
  const auto place = std::find(techniques.begin(), techniques.end(), technique);
  if (place != techniques.end())
    session.comparison.active = std::size_t(place - techniques.begin());
  return session;
}

Ids idsOf(const Session& session) {
  Ids ids;
  for (const Pane& pane : comparisonOf(session).panes) ids.push_back(pane.technique);
  return ids;
}

std::size_t activeOf(const Session& session) {
  return comparisonOf(session).active;
}

int radiusOf(const Session& session, std::size_t pane) {
  return activated(session, pane).frame.kernel.radius;
}

double reductionOf(const Session& session, std::size_t pane) {
  const ParameterValues values = parametersOf(activated(session, pane), "vsm");
  const auto found = values.find("bleed-reduction");
  return found == values.end() ? 0.0 : std::get<double>(found->second);
}

TEST(Comparison, TheSessionsTechniqueIsAlwaysShown) {
  EXPECT_EQ(idsOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "msm")), (Ids{"pcf", "msm"}));
  EXPECT_EQ(idsOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "esm")), (Ids{"esm", "msm"}));
  for (const char* id : {"vsm", "hard"}) {
    const Session session = comparing(ComparisonMode::Grid, {}, id);
    const Ids panes = idsOf(session);
    EXPECT_GE(panes.size(), Comparison::fewest);
    EXPECT_EQ(std::count(panes.begin(), panes.end(), id), 1);
    EXPECT_EQ(panes[activeOf(session)], id);
  }
}

TEST(Comparison, AChosenTechniqueTakesThePlaceOfTheOneThatWas) {
  Session session = comparing(ComparisonMode::Grid, {"pcf", "msm", "vsm"}, "msm");
  chooseTechnique(session, "esm");
  EXPECT_EQ(session.technique, "esm");
  EXPECT_EQ(idsOf(session), (Ids{"pcf", "esm", "vsm"}));
  chooseTechnique(session, "vsm");
  EXPECT_EQ(session.technique, "vsm");
  EXPECT_EQ(idsOf(session), (Ids{"pcf", "esm", "vsm"}));
  EXPECT_EQ(activeOf(session), 2u);
}

TEST(Comparison, WithoutOneTheListStays) {
  Session session = comparing(ComparisonMode::Single, {"pcf", "msm"}, "msm");
  chooseTechnique(session, "esm");
  EXPECT_EQ(session.technique, "esm");
  EXPECT_EQ(session.comparison.panes, linkedPanes({"pcf", "msm"}));
}

TEST(Comparison, AWipesOtherSideStaysUnlessItIsChosen) {
  Session session = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "evsm4", "msm"}, "vsm");
  for (const char* id : {"msm", "pcf", "evsm4", "vsm"}) {
    chooseTechnique(session, id);
    EXPECT_EQ(session.technique, id);
    EXPECT_EQ(idsOf(session)[0], id);
    EXPECT_EQ(idsOf(session)[1], "lvsm") << id;
  }
  // What both sides show stays where it is; the other one becomes the active one.
  chooseTechnique(session, "lvsm");
  EXPECT_EQ(session.technique, "lvsm");
  EXPECT_EQ(activeOf(session), 1u);
  EXPECT_EQ(idsOf(session)[0], "vsm");
  EXPECT_EQ(idsOf(session)[1], "lvsm");
}

TEST(Comparison, AWipeHasTheActivePaneOnOneOfItsSides) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "msm");
  setMode(session, ComparisonMode::Wipe);
  EXPECT_EQ(shownPanes(session.comparison), 2u);
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "msm", "lvsm"}));
  EXPECT_EQ(activeOf(session), 1u);
}

TEST(Comparison, SidesChangePlacesWhenOneTakesTheOthersTechnique) {
  Session session = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(session, 1, "vsm");
  EXPECT_EQ(idsOf(session), (Ids{"lvsm", "vsm", "msm"}));
  EXPECT_EQ(session.technique, "vsm");
  EXPECT_EQ(activeOf(session), 1u);
  choosePane(session, 0, "pcf");
  EXPECT_EQ(session.technique, "vsm");
  EXPECT_EQ(idsOf(session)[0], "pcf");
}

TEST(Comparison, APanesTechniqueIsExchangedAndNoneOfTheLinkedIsThereTwice) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(session, 1, "pcf");
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "pcf", "msm"}));
  EXPECT_EQ(session.technique, "vsm");
  choosePane(session, 1, "msm");
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "msm", "pcf"}));
  choosePane(session, 0, "esm");
  EXPECT_EQ(idsOf(session), (Ids{"esm", "msm", "pcf"}));
  EXPECT_EQ(session.technique, "esm");
  choosePane(session, 0, "pcf");
  EXPECT_EQ(idsOf(session), (Ids{"pcf", "msm", "esm"}));
  EXPECT_EQ(session.technique, "pcf");
  EXPECT_EQ(activeOf(session), 0u);
}

TEST(Comparison, PanesAreAddedAndTakenAwayButNotTheActiveOne) {
  const Ids known{"hard", "pcf", "vsm", "esm", "msm", "csm"};
  Session session = comparing(ComparisonMode::Grid, {"pcf", "vsm", "msm"}, "msm");
  setPaneCount(session, 2, known);
  EXPECT_EQ(idsOf(session), (Ids{"pcf", "msm"}));
  EXPECT_EQ(activeOf(session), 1u);
  setPaneCount(session, 6, known);
  EXPECT_EQ(idsOf(session), (Ids{"pcf", "msm", "vsm", "lvsm", "evsm4", "hard"}));
}

TEST(Comparison, LinkedPanesFollowTheSession) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  session.frame.kernel.radius = 9;
  EXPECT_EQ(radiusOf(session, 1), 9);
  activatePane(session, 1);
  session.frame.kernel.radius = 4;
  EXPECT_EQ(radiusOf(session, 0), 4);
}

TEST(Comparison, ADuplicateIsSetByItself) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  session.frame.kernel.radius = 3;
  duplicatePane(session, 0);
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "vsm", "msm"}));
  EXPECT_EQ(activeOf(session), 1u);
  session.frame.kernel.radius = 12;
  setParameters(session, "vsm", {{"bleed-reduction", 0.3}});
  EXPECT_EQ(radiusOf(session, 0), 3);
  EXPECT_EQ(radiusOf(session, 1), 12);
  EXPECT_EQ(radiusOf(session, 2), 3);
  EXPECT_EQ(reductionOf(session, 0), 0.0);
  EXPECT_EQ(reductionOf(session, 1), 0.3);
  // Whoever goes to another pane leaves them as they are.
  const Session before = session;
  activatePane(session, 2);
  EXPECT_EQ(session.frame.kernel.radius, 3);
  session.frame.kernel.radius = 5;  // of the panes that share it
  EXPECT_EQ(radiusOf(session, 0), 5);
  EXPECT_EQ(radiusOf(session, 1), 12);
  session.frame.kernel.radius = 3;
  activatePane(session, 1);
  EXPECT_EQ(session, before);
}

TEST(Comparison, AnotherTechniqueInAPaneOfItsOwnTakesNoParametersAlong) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  duplicatePane(session, 0);
  session.frame.kernel.radius = 12;
  setParameters(session, "vsm", {{"bleed-reduction", 0.3}});
  chooseTechnique(session, "msm");  // in place, although a linked pane has it
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "msm", "msm"}));
  EXPECT_EQ(activeOf(session), 1u);
  EXPECT_EQ(session.frame.kernel.radius, 12);
  EXPECT_EQ(reductionOf(session, 0), 0.0);
  EXPECT_TRUE(parametersOf(session, "msm").empty());
  EXPECT_EQ(radiusOf(session, 2), 3);
}

TEST(Comparison, SettingsBecomeOwnAndSharedOneByOne) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  for (const std::size_t pane : {0u, 1u}) {
    SCOPED_TRACE(pane);
    for (int i = 0; i <= int(PaneSetting::Bias); ++i) {
      Session changed = session;
      setOwn(changed, pane, PaneSetting(i), true);
      for (int other = 0; other <= int(PaneSetting::Bias); ++other)
        EXPECT_EQ(hasOwn(changed.comparison.panes[pane], PaneSetting(other)), other == i);
      EXPECT_FALSE(changed.comparison.panes[pane].linked());
      setOwn(changed, pane, PaneSetting(i), false);
      EXPECT_EQ(changed, session);
    }
  }
  duplicatePane(session, 0);
  session.frame.kernel.radius = 12;
  session.frame.map.format = StorageFormat::Half;
  setOwn(session, 1, PaneSetting::Kernel, false);
  EXPECT_EQ(session.frame.kernel.radius, 3);  // as the others
  EXPECT_EQ(session.frame.map.format, StorageFormat::Half);
  session.frame.kernel.radius = 7;
  EXPECT_EQ(radiusOf(session, 0), 7);
  setLinked(session, 1, true);
  EXPECT_TRUE(session.comparison.panes[1].linked());
  EXPECT_EQ(session.frame.map.format, StorageFormat::Float);
}

TEST(Comparison, APaneTakesTheActiveOnesSettings) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm", "esm"}, "vsm");
  duplicatePane(session, 0);  // [vsm, vsm*, msm, esm]
  session.frame.kernel.radius = 12;
  setParameters(session, "vsm", {{"bleed-reduction", 0.3}});
  copyActiveSettings(session, 2);
  EXPECT_EQ(radiusOf(session, 2), 12);
  EXPECT_FALSE(session.comparison.panes[2].own.parameters);
  copyActiveSettings(session, 0);
  EXPECT_EQ(reductionOf(session, 0), 0.3);
  EXPECT_EQ(radiusOf(session, 3), 3);
  activatePane(session, 3);
  copyActiveSettings(session, 1);
  EXPECT_EQ(radiusOf(session, 1), 3);
  EXPECT_EQ(reductionOf(session, 1), 0.3);  // of another technique than the active one
  copyActiveSettings(session, 3);           // itself
  EXPECT_TRUE(session.comparison.panes[3].linked());
}

TEST(Comparison, OfOnePictureADuplicateMakesTwoPanes) {
  Session session = comparing(ComparisonMode::Single, {}, "vsm");
  duplicatePane(session, comparisonOf(session).active);
  EXPECT_EQ(session.comparison.mode, ComparisonMode::Grid);
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "vsm"}));
  EXPECT_EQ(activeOf(session), 1u);
}

TEST(Comparison, InAWipeADuplicateIsTheOtherSide) {
  for (const char* technique : {"vsm", "msm"}) {
    Session session = comparing(ComparisonMode::Wipe, {"vsm", "msm", "esm"}, technique);
    duplicatePane(session, comparisonOf(session).active);
    EXPECT_EQ(shownPanes(comparisonOf(session)), 2u);
    EXPECT_EQ(idsOf(session)[0], technique);
    EXPECT_EQ(idsOf(session)[1], technique);
    EXPECT_EQ(activeOf(session), 1u);
    EXPECT_TRUE(session.comparison.panes[0].linked());
  }
}

TEST(Comparison, ThereAreNeverMoreThanSixPanes) {
  for (const std::size_t pane : {0u, 5u}) {
    Session session =
        comparing(ComparisonMode::Wipe, {"hard", "pcf", "vsm", "esm", "lvsm", "msm"}, "hard");
    session.comparison.mode = ComparisonMode::Grid;
    duplicatePane(session, pane);
    EXPECT_EQ(session.comparison.panes.size(), Comparison::most);
    EXPECT_EQ(session.technique, pane == 0 ? "hard" : "msm");
    EXPECT_EQ(session.comparison.panes[activeOf(session) - 1].technique, session.technique);
  }
}

TEST(Comparison, OnePicturesDuplicateStandsBesideWhatWasSet) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "msm");
  for (const std::size_t pane : {0u, 2u}) setOwn(session, pane, PaneSetting::Kernel, true);
  activatePane(session, 0);
  session.frame.kernel.radius = 9;
  activatePane(session, 2);
  setMode(session, ComparisonMode::Single);
  duplicatePane(session, 2);
  EXPECT_EQ(session.comparison.mode, ComparisonMode::Grid);
  EXPECT_EQ(idsOf(session), (Ids{"vsm", "msm", "msm"}));
  EXPECT_EQ(activeOf(session), 2u);
  EXPECT_EQ(radiusOf(session, 0), 9);
}

TEST(Comparison, AClosedSideLeavesThePanesBehindAWipe) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm", "esm", "pcf"}, "esm");
  setOwn(session, 2, PaneSetting::Kernel, true);
  session.frame.kernel.radius = 12;
  for (const std::size_t closed : {0u, 1u})
    for (const std::size_t active : {0u, 1u}) {
      Session wipe = activated(session, active);
      setMode(wipe, ComparisonMode::Wipe);
      closePane(wipe, closed);
      EXPECT_EQ(wipe.comparison.mode, ComparisonMode::Single);
      const char* const left = closed == 0 ? "msm" : "vsm";
      EXPECT_EQ(wipe.technique, left);
      EXPECT_EQ(wipe.frame.kernel.radius, Kernel{}.radius);
      setMode(wipe, ComparisonMode::Grid);
      EXPECT_EQ(idsOf(wipe), (Ids{left, "esm", "pcf"}));
      EXPECT_EQ(activeOf(wipe), 0u);
      EXPECT_EQ(radiusOf(wipe, 1), 12);
    }
}

TEST(Comparison, AClosedPaneLeavesTheOthersAsTheyAre) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "msm"}, "vsm");
  duplicatePane(session, 0);
  session.frame.kernel.radius = 12;
  Session inactive = session;
  closePane(inactive, 0);
  EXPECT_EQ(idsOf(inactive), (Ids{"vsm", "msm"}));
  EXPECT_EQ(activeOf(inactive), 0u);
  EXPECT_EQ(inactive.frame.kernel.radius, 12);
  EXPECT_EQ(radiusOf(inactive, 1), 3);
  closePane(session, 1);
  EXPECT_EQ(session.technique, "vsm");
  EXPECT_EQ(session.frame.kernel.radius, 3);
  EXPECT_TRUE(session.comparison.panes[0].linked());
  // The last but one: what stays is the picture, as it was.
  closePane(inactive, 1);
  EXPECT_EQ(inactive.comparison, Comparison{});
  EXPECT_EQ(inactive.frame.kernel.radius, 12);
}

}  // namespace
}  // namespace umbra

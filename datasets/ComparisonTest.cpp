#include "datasets/Comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "datasets/Session.h"

namespace umbra {
namespace {

using Ids = std::vector<std::string>;

Session comparing(ComparisonMode mode, Ids techniques, const char* technique) {
  Session session;
  session.technique = technique;
  session.comparison = {mode, std::move(techniques), 0.5};
  return session;
}

TEST(Comparison, TheSessionsTechniqueIsAlwaysShown) {
  EXPECT_EQ(panesOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "msm")), (Ids{"pcf", "msm"}));
  EXPECT_EQ(panesOf(comparing(ComparisonMode::Grid, {"pcf", "msm"}, "esm")), (Ids{"esm", "msm"}));
  for (const char* id : {"vsm", "hard"}) {
    const Ids panes = panesOf(comparing(ComparisonMode::Grid, {}, id));
    EXPECT_GE(panes.size(), Comparison::fewest);
    EXPECT_EQ(std::count(panes.begin(), panes.end(), id), 1);
  }
}

TEST(Comparison, AChosenTechniqueTakesThePlaceOfTheOneThatWas) {
  Session session = comparing(ComparisonMode::Grid, {"pcf", "msm", "vsm"}, "msm");
  chooseTechnique(session, "esm");
  EXPECT_EQ(session.technique, "esm");
  EXPECT_EQ(panesOf(session), (Ids{"pcf", "esm", "vsm"}));
  chooseTechnique(session, "vsm");
  EXPECT_EQ(session.technique, "vsm");
  EXPECT_EQ(panesOf(session), (Ids{"pcf", "esm", "vsm"}));
}

TEST(Comparison, WithoutOneTheListStays) {
  Session session = comparing(ComparisonMode::Single, {"pcf", "msm"}, "msm");
  chooseTechnique(session, "esm");
  EXPECT_EQ(session.technique, "esm");
  EXPECT_EQ(session.comparison.techniques, (Ids{"pcf", "msm"}));
}

TEST(Comparison, AWipesRightSideStaysUnlessItIsChosen) {
  Session session = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "evsm4", "msm"}, "vsm");
  EXPECT_EQ(wipeTechniqueOf(session), "lvsm");
  for (const char* id : {"msm", "pcf", "evsm4", "vsm"}) {
    chooseTechnique(session, id);
    EXPECT_EQ(session.technique, id);
    EXPECT_EQ(wipeTechniqueOf(session), "lvsm") << id;
  }
  chooseTechnique(session, "lvsm");
  EXPECT_EQ(session.technique, "lvsm");
  EXPECT_EQ(wipeTechniqueOf(session), "vsm");
}

TEST(Comparison, AWipesSidesChangePlacesWhenTheRightOneTakesTheLeftOnes) {
  Session session = comparing(ComparisonMode::Wipe, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(session, "lvsm", "vsm");
  EXPECT_EQ(session.technique, "lvsm");
  EXPECT_EQ(wipeTechniqueOf(session), "vsm");
  choosePane(session, "vsm", "pcf");
  EXPECT_EQ(session.technique, "lvsm");
  EXPECT_EQ(wipeTechniqueOf(session), "pcf");
  choosePane(session, "pcf", "msm");
  EXPECT_EQ(session.technique, "lvsm");
  EXPECT_EQ(wipeTechniqueOf(session), "msm");
}

TEST(Comparison, APanesTechniqueIsExchangedAndNoneIsThereTwice) {
  Session session = comparing(ComparisonMode::Grid, {"vsm", "lvsm", "msm"}, "vsm");
  choosePane(session, "lvsm", "pcf");
  EXPECT_EQ(panesOf(session), (Ids{"vsm", "pcf", "msm"}));
  EXPECT_EQ(session.technique, "vsm");
  choosePane(session, "pcf", "msm");
  EXPECT_EQ(panesOf(session), (Ids{"vsm", "msm", "pcf"}));
  choosePane(session, "vsm", "esm");
  EXPECT_EQ(panesOf(session), (Ids{"esm", "msm", "pcf"}));
  EXPECT_EQ(session.technique, "esm");
}

TEST(Comparison, PanesAreAddedAndTakenAwayButNotTheSessions) {
  const Ids known{"hard", "pcf", "vsm", "esm", "msm", "csm"};
  Session session = comparing(ComparisonMode::Grid, {"pcf", "vsm", "msm"}, "msm");
  setPaneCount(session, 2, known);
  EXPECT_EQ(panesOf(session), (Ids{"pcf", "msm"}));
  setPaneCount(session, 6, known);
  EXPECT_EQ(panesOf(session), (Ids{"pcf", "msm", "vsm", "lvsm", "evsm4", "hard"}));
}

}  // namespace
}  // namespace umbra

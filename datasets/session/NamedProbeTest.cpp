#include "datasets/session/NamedProbe.h"

#include <gtest/gtest.h>

#include "datasets/session/Session.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

NamedProbe at(const std::string& name) {
  return {name, Eigen::Vector3d(1, 2, 3), {}, {}};
}

TEST(NamedProbe, ANameThatIsTakenIsCountedOn) {
  Session session;
  EXPECT_EQ(freeProbeName(session.probes, "Bench"), "Bench");
  for (const char* name : {"Bench", "Bench 2", "Bench 4"}) saveProbe(session, at(name));
  EXPECT_EQ(freeProbeName(session.probes, "Bench"), "Bench 3");
}

TEST(NamedProbe, RenamingAndDroppingFollowTheOneTheProbeIsAt) {
  Session session;
  saveProbe(session, at("a"));
  saveProbe(session, at("b"));
  EXPECT_EQ(session.keptProbe, "b");
  renameProbe(session, "b", "c");
  EXPECT_EQ(session.keptProbe, "c");
  renameProbe(session, "a", "d");
  EXPECT_EQ(session.keptProbe, "c");
  EXPECT_EQ(namesOf(session.probes), (std::vector<std::string>{"d", "c"}));
  dropProbe(session, "d");
  EXPECT_EQ(session.keptProbe, "c");
  dropProbe(session, "c");
  EXPECT_EQ(session.keptProbe, "");
  EXPECT_TRUE(session.probes.empty());
}

TEST(NamedProbe, WhatCannotBeKeptLeavesTheSessionAsItWas) {
  Session session;
  for (std::size_t i = 1; i < NamedProbe::most; ++i) saveProbe(session, at(std::to_string(i)));
  const Session before = session;
  EXPECT_THROW(saveProbe(session, at("1")), Error);
  EXPECT_THROW(renameProbe(session, "1", "2"), Error);
  EXPECT_THROW(renameProbe(session, "1", " "), Error);
  EXPECT_THROW(renameProbe(session, "x", "y"), Error);
  EXPECT_THROW(dropProbe(session, "x"), Error);
  EXPECT_EQ(session, before);
  renameProbe(session, "1", "1");  // to its own name is no clash
  EXPECT_EQ(session, before);
  saveProbe(session, at("last"));
  EXPECT_THROW(saveProbe(session, at("one more")), Error);
  EXPECT_EQ(session.probes.size(), NamedProbe::most);
}

}  // namespace
}  // namespace umbra

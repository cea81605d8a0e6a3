#include "datasets/session/Session.h"

#include <gtest/gtest.h>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

class SessionTest : public testing::Test {
 protected:
  void set(const std::string& name, const ParameterValue& value) {
    editParameters(session, catalogue, "lvsm", [&](std::span<const Parameter> parameters) {
      parameterNamed(parameters, name, "lvsm").set(value, "lvsm." + name);
    });
  }
  // The value that a technique made of the session has.
  ParameterValue value(const std::string& name) const {
    const std::unique_ptr<Technique> technique = techniqueOf(session, catalogue, "lvsm");
    return parameterNamed(technique->parameters(), name, "lvsm").get();
  }

  const TechniqueCatalogue catalogue = allTechniques();
  const std::vector<double> two{0.2, 0.5};
  Session session;
};

TEST_F(SessionTest, AnotherNumberOfLayersDropsTheSplits) {
  set("splits", two);
  EXPECT_EQ(value("layers"), ParameterValue(3));
  for (int layers : {7, 4}) {  // 4 is the default
    set("splits", two);
    set("layers", layers);
    EXPECT_EQ(value("layers"), ParameterValue(layers));
    EXPECT_EQ(value("splits"), ParameterValue(std::vector<double>()));
  }
  set("splits", two);
  EXPECT_EQ(value("layers"), ParameterValue(3));
  EXPECT_EQ(value("splits"), ParameterValue(two));
}

TEST_F(SessionTest, AnotherPlacementDropsTheSplits) {
  set("splits", two);
  set("placement", std::string("lloyd"));
  EXPECT_EQ(value("placement"), ParameterValue(std::string("lloyd")));
  EXPECT_EQ(value("layers"), ParameterValue(3));
  set("splits", two);
  EXPECT_EQ(value("placement"), ParameterValue(std::string("manual")));
}

TEST_F(SessionTest, OnlyWhatDiffersFromTheDefaultsIsStored) {
  set("overlap", 0.02);
  EXPECT_EQ(session.parameters,
            (TechniqueParameters{{"lvsm", {{"overlap", ParameterValue(0.02)}}}}));
  set("overlap", 0.01);
  EXPECT_TRUE(session.parameters.empty());
}

TEST_F(SessionTest, WhatIsRefusedChangesNothing) {
  set("splits", two);
  const Session before = session;
  EXPECT_THROW(set("layers", 17), Error);
  EXPECT_THROW(set("splits", std::vector<double>{0.5, 0.2}), Error);
  EXPECT_EQ(session, before);
}

TEST_F(SessionTest, ALimitOfTheFormatIsNotStored) {
  session.frame.map.format = StorageFormat::Half;
  session.parameters["esm"]["exponent"] = 100.0;
  editParameters(session, catalogue, "esm", [](std::span<const Parameter>) {});
  EXPECT_EQ(session.parameters.at("esm").at("exponent"), ParameterValue(100.0));
}

TEST(Session, TellsWhatATableOfSumsLoses) {
  const TechniqueCatalogue catalogue = allTechniques();
  const auto lossOf = [&](const Session& session, const std::string& id) {
    return whyReadInexactly(session, *techniqueOf(session, catalogue, id));
  };
  Session session;
  session.frame.read.filter = ReadFilter::SummedArea;
  EXPECT_NE(lossOf(session, "esm").find("filter sat"), std::string::npos);
  EXPECT_FALSE(lossOf(session, "evsm4").empty());
  EXPECT_TRUE(lossOf(session, "vsm").empty());
  EXPECT_TRUE(lossOf(session, "pcf").empty());
  session.source.kind = SourceKind::DepthFile;  // read at its texels
  EXPECT_TRUE(lossOf(session, "esm").empty());
}

}  // namespace
}  // namespace umbra

// A spot light's shadow map, as engines write it, gives the figures of its linear twin.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

constexpr double near = 0.5, far = 8.0;

class DepthProjection : public testing::Test {
 protected:
  // A map of half occluder at distance 2, half receiver at 6, as `value` of a distance.
  template <class Value>
  std::string write(const std::string& name, const Value& value) const {
    Image<float> map(16, 16);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) map(x, y) = float(value(x < 8 ? 2.0 : 6.0));
    writeMap(folder.file(name), map);
    return folder.file(name);
  }
  Json probe(const std::string& file, const std::string& receiver, Arguments more = {},
             const std::string& texel = "2,8") const {
    Arguments arguments{"probe",    "--json",     "--depth", file,    "--texel",
                        texel,      "--receiver", receiver,  "--set", "esm.exponent=11",
                        "--radius", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).json();
  }
  static double visibility(const Json& object, const std::string& name) {
    for (const Json& row : object["techniques"])
      if (row["name"] == name) return row["visibility"];
    ADD_FAILURE() << name;
    return 0.0;
  }

  const TemporaryFolder folder;
};

double perspective(double z) {
  return far * (z - near) / (z * (far - near));
}

// exp(−11 (0.73333 − 0.2)) of linear depths, and exp(−11 (0.97778 − 0.8)) of the stored ones.
TEST_F(DepthProjection, IsUndoneBeforeATechniqueSeesADepth) {
  const std::string file = write("m.exr", perspective);
  const Arguments undo{"--depth-projection", "perspective:0.5,8"};
  EXPECT_NEAR(visibility(probe(file, "0.7333333333", undo), "esm"), 0.002832, 2e-6);
  EXPECT_NEAR(visibility(probe(file, "0.9777777778"), "esm"), 0.141486, 2e-6);
}

TEST_F(DepthProjection, TakesAndTellsTheReceiverInThreeMeasures) {
  const std::string file = write("m.exr", perspective);
  const Arguments undo{"--depth-projection", "perspective:0.5,8"};
  for (const std::string receiver : {"0.73333333333", "6w", "0.97777777778f"}) {
    const Json object = probe(file, receiver, undo);
    // Floats near 1 have steps of 6e-8, which the perspective stretches by 67 in world units.
    EXPECT_NEAR(object["receiver"], 5.5 / 7.5, 3e-7) << receiver;
    EXPECT_NEAR(object["receiverWorld"], 6.0, 2e-6) << receiver;
    EXPECT_NEAR(object["receiverFile"], 0.97777777778, 3e-8) << receiver;
  }
  for (const std::string receiver : {"9w", "0.4w", "1.5", "6x", "w", "1.01f"}) {
    const Outcome outcome = run({"probe", "--json", "--depth", file, "--texel", "2,8", "--receiver",
                                 receiver, "--depth-projection", "perspective:0.5,8"});
    EXPECT_EQ(outcome.status, 2) << receiver;
    EXPECT_NE(outcome.err.find("--receiver"), std::string::npos) << outcome.err;
  }
}

// Equality is lit: a receiver at a texel's own depth, in whatever measure it is told.
TEST_F(DepthProjection, NamesTheReceiverOfAComparisonInThreeMeasures) {
  const std::string file = write("m.exr", perspective);
  const Json object = run({"compare", "--json", "--depth", file, "--depth-projection",
                           "perspective:0.5,8", "--receiver", "6w", "--technique", "vsm"})
                          .json();
  EXPECT_EQ(object["source"]["name"], "m.exr");
  EXPECT_EQ(object["source"]["origin"], Json::parse("[0,0]"));
  EXPECT_NEAR(object["receiver"], 5.5 / 7.5, 1e-6);
  EXPECT_NEAR(object["receiverWorld"], 6.0, 1e-5);
  EXPECT_NEAR(object["receiverFile"], 0.97778, 5e-6);
}

TEST_F(DepthProjection, LightsAReceiverThatATexelHolds) {
  const std::pair<std::string, std::string> maps[] = {
      {"perspective:0.5,8", write("p.exr", perspective)},
      {"reversed:0.5,8",
       write("r.exr", [](double z) { return near * (far - z) / (z * (far - near)); })},
      {"reversed-infinite:0.5:8", write("i.exr", [](double z) { return near / z; })}};
  for (const auto& [projection, file] : maps)
    EXPECT_EQ(probe(file, "6w", {"--depth-projection", projection}, "12,8")["reference"], 1.0)
        << projection;
  EXPECT_EQ(probe(maps[0].second, "0.9777778f", {"--depth-projection", "perspective:0.5,8"},
                  "12,8")["reference"],
            1.0);
  const std::string flat = write("f.exr", [](double) { return 0.7; });
  EXPECT_EQ(probe(flat, "0.7f")["reference"], 1.0);
  EXPECT_EQ(probe(flat, "0.7w")["reference"], 1.0);
  EXPECT_EQ(probe(flat, "0.7f", {"--depth-range", "0,0.7"})["receiver"], 1.0);
  EXPECT_EQ(probe(flat, "0.7f", {"--depth-range", "0,0.7"})["reference"], 1.0);
}

TEST_F(DepthProjection, GivesEveryTechniqueTheLinearTwinsNumbers) {
  const std::string linear =
      write("linear.exr", [](double z) { return (z - near) / (far - near); });
  const std::pair<std::string, std::string> others[] = {
      {"perspective:0.5,8", write("p.exr", perspective)},
      {"reversed:0.5,8", write("r.exr", [](double z) { return 1.0 - perspective(z); })},
      {"reversed-infinite:0.5:8", write("i.exr", [](double z) { return near / z; })}};
  const Json twin = probe(linear, "0.7", {}, "8,8");
  for (const auto& [projection, file] : others) {
    const Json object = probe(file, "0.7", {"--depth-projection", projection}, "8,8");
    ASSERT_EQ(object["techniques"].size(), twin["techniques"].size());
    for (const Json& row : twin["techniques"])
      EXPECT_NEAR(visibility(object, row["name"]), row["visibility"], 1e-6)
          << projection << " " << row["name"];
  }
  // Stored values that grow towards the light, without a projection.
  const std::string turned =
      write("t.exr", [](double z) { return 1.0 - (z - near) / (far - near); });
  const Json reversed = probe(turned, "0.7", {"--depth-range", "1,0"}, "8,8");
  for (const Json& row : twin["techniques"])
    EXPECT_NEAR(visibility(reversed, row["name"]), row["visibility"], 1e-6) << row["name"];
}

TEST_F(DepthProjection, IsKeptInTheSessionOfWhatIsWritten) {
  const std::string file = write("m.exr", perspective);
  const std::string session = folder.file("s.json");
  std::ofstream(session)
      << R"({"format": "umbrascope-session/1", "source": {"depth": ")" << file
      << R"(", "projection": "perspective:0.5,8", "miss": "clamp"}, "probe": [2, 8], "receiver": 0.5})";
  const Json object = run({"probe", "--json", "--session", session}).json();
  EXPECT_NEAR(object["statistics"]["mean"], 0.2, 1e-6);
  const Json other =
      run({"probe", "--json", "--session", session, "--depth-projection", "linear"}).json();
  EXPECT_NEAR(other["statistics"]["mean"], 0.8, 1e-6);
}

}  // namespace
}  // namespace umbra::cli

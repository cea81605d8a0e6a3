// Probes that a session saves, read by their names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

const Arguments threeTechniques{"--technique", "pcf,vsm,esm"};

class NamedProbes : public testing::Test {
 protected:
  // A probe as a session file holds it.
  Json session(const std::string& scene, const Json& probes) const {
    return {{"format", "umbrascope-session/1"},
            {"source", {{"scene", scene}}},
            {"frame", {{"mapSize", 256}}},
            {"size", {160, 120}},
            {"probes", probes}};
  }
  std::string write(const Json& json) const {
    const std::string file = folder.file("s.json");
    std::ofstream(file) << json;
    return file;
  }
  Outcome probe(const Json& json, const Arguments& more) const {
    Arguments arguments{"probe", "--session", write(json)};
    arguments.insert(arguments.end(), threeTechniques.begin(), threeTechniques.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  Json probed(const Json& json, Arguments more) const {
    more.push_back("--json");
    return probe(json, more).json();
  }
  void expectError(int status, const std::string& text, const Outcome& outcome) const {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder;
};

// Where a saved point lies in the middle of its pixel, its probe equals that of the pixel, to the
// last digit of what --pixel says.
TEST_F(NamedProbes, InSightAProbeIsThatOfItsPixel) {
  for (const char* filter : {"bilinear", "anisotropic", "sat"}) {
    const Arguments read{"--filter", filter, "--cascades", "2"};
    Arguments worst = read;
    worst.insert(worst.end(), {"--pixel", "worst"});
    Json expected = probed(session("two-planes", Json::array()), worst);
    const Json kept = session("two-planes", {{{"name", "Spot"}, {"point", expected["world"]}}});
    Arguments named = read;
    named.insert(named.end(), {"--named", "Spot"});
    expected["name"] = "Spot";
    EXPECT_EQ(probed(kept, named), expected) << filter;
    EXPECT_TRUE(expected["techniques"][0].contains("gpu"));
  }
}

// Beside its pixel's middle a point is read by a calculation on the CPU, which nearly agrees with
// the GPU's.
TEST_F(NamedProbes, BesideThePixelsMiddleTheReadIsComputedAsTheGpuDoesIt) {
  for (const char* filter : {"trilinear", "anisotropic", "sat"}) {
    Json json = session("two-planes", Json::array());
    json["camera"] = {{"position", {1, 4, 7}}, {"target", {0, 0, 0}}, {"viewAngle", 30}};
    const Arguments read{"--filter", filter, "--cascades", "2"};
    Arguments there = read, named = read;
    there.insert(there.end(), {"--pixel", "80,66"});
    named.insert(named.end(), {"--named", "Spot"});
    const Json seen = probed(json, there);
    const auto at = [&](int i) { return seen["world"][i].get<double>(); };
    const double dx = 1 - at(0), dy = 4 - at(1), dz = 7 - at(2);
    const double distance = std::hypot(dx, dy, dz), angle = std::atan(1.0) * 2.0 / 3.0 / 120;
    const double beside = 0.02 * distance * angle;  // a fiftieth of a pixel along the ground
    json["probes"] = {{{"name", "Spot"}, {"point", {at(0) + beside, at(1), at(2)}}}};
    const Json computed = probed(json, named);
    EXPECT_EQ(computed["pixel"], seen["pixel"]);
    EXPECT_EQ(computed["cascade"], seen["cascade"]);
    for (const Json& row : computed["techniques"]) EXPECT_FALSE(row.contains("gpu"));
    // The GPU takes its difference up to a pixel away. A pixel's length on the ground is
    // proportional to the squared distance over the camera's height, so that it changes by two
    // angles of a pixel over the slope.
    const double change = 2.0 * angle * std::hypot(dx, dz) / dy;
    for (const char* side : {"x", "y"}) {
      const double gpu = seen["footprint"][side], ours = computed["footprint"][side];
      EXPECT_NEAR(ours, gpu, change * std::abs(gpu)) << filter;
    }
    EXPECT_EQ(computed["footprint"]["probes"], seen["footprint"]["probes"]);
    EXPECT_NEAR(computed["receiver"].get<double>(), seen["receiver"].get<double>(),
                1000.0 * std::ldexp(1.0, -24));
  }
}

// The texels that a point or bilinear read of a single map averages do not depend on the camera.
TEST_F(NamedProbes, OutOfSightAProbeIsReadAllTheSame) {
  const Json seen = probed(session("two-planes", Json::array()), {"--pixel", "worst"});
  Json hidden = session("two-planes", {{{"name", "Spot"}, {"point", seen["world"]}}});
  const auto withCamera = [&](double x, double y, double z) {
    const Json world = seen["world"];
    const auto at = [&](int i) { return world[i].get<double>(); };
    // The camera looks away from the point.
    hidden["camera"] = {{"position", {at(0) + x, at(1) + y, at(2) + z}},
                        {"target", {at(0) + 2 * x, at(1) + 2 * y, at(2) + 2 * z}}};
    return probed(hidden, {"--named", "Spot"});
  };
  const Json left = withCamera(-3, 2, 1), right = withCamera(4, 1, 2);
  EXPECT_EQ(left, right);
  EXPECT_TRUE(left["hidden"]);
  EXPECT_FALSE(left.contains("pixel"));
  for (const Json& row : left["techniques"]) EXPECT_FALSE(row.contains("gpu"));
  EXPECT_EQ(left["region"], seen["region"]);
  EXPECT_EQ(left["world"], seen["world"]);
  // A depth of 24 bits between planes of at most 1 : 1000 is good to 2⁻²⁴ · 1000 of the distance
  // from the camera, which stands within the light's range.
  EXPECT_NEAR(left["receiver"].get<double>(), seen["receiver"].get<double>(),
              1000.0 * std::ldexp(1.0, -24));

  // A wider read has the pixel's size, which is unknown here.
  expectError(2, "--named: Spot: not in sight",
              probe(hidden, {"--named", "Spot", "--filter", "trilinear"}));
}

// Errors are against the value that the table calls the truth.
TEST_F(NamedProbes, RaysAreTheTableTruthWhereTheyAreAskedFor) {
  const Json spot = probed(session("two-planes", Json::array()), {"--pixel", "worst"});
  const Json json = session("two-planes", {{{"name", "Spot"}, {"point", spot["world"]}}});
  const std::string out = folder.file("probes");
  const Outcome done = probe(json, {"--named", "all", "--reference", "raytraced", "-o", out});
  ASSERT_EQ(done.status, 0) << done.err;
  std::ifstream table(out + "/probes.csv");
  std::string heading, line;
  ASSERT_TRUE(std::getline(table, heading) && std::getline(table, line));
  std::vector<double> numbers;
  std::stringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(std::strtod(field.c_str(), nullptr));
  // name, x, y, z, receiver, truth, then visibility and error of each technique, and a note.
  const double truth = numbers.at(5);
  EXPECT_EQ(truth, spot["raytraced"]);
  for (std::size_t i = 6; i + 1 < numbers.size() - 1; i += 2)
    EXPECT_NEAR(numbers[i] - truth, numbers[i + 1], 1e-15) << heading;
  EXPECT_GE(numbers.size(), 8u);
}

TEST_F(NamedProbes, AllOfThemAreOneTable) {
  const Json spot = probed(session("two-planes", Json::array()), {"--pixel", "worst"});
  const Json json =
      session("two-planes", {{{"name", "a, \"b\""}, {"point", spot["world"]}},
                             {{"name", "Deep"}, {"point", spot["world"]}, {"receiver", 0.875}},
                             {{"name", "Nowhere"}, {"point", {0, 500, 0}}}});
  const Json table = probed(json, {"--named", "all"});
  EXPECT_EQ(table["format"], "umbrascope-probes/1");
  EXPECT_EQ(table["source"], spot["source"]);
  ASSERT_EQ(table["probes"].size(), 3u);
  Json first = probed(json, {"--named", "a, \"b\""});
  for (const char* key : {"format", "source"}) first.erase(key);
  EXPECT_EQ(table["probes"][0], first);
  EXPECT_EQ(table["probes"][1]["receiver"], 0.875);
  EXPECT_FALSE(
      table["probes"][1]["techniques"][0].contains("gpu"));  // the frame does not show the point
  EXPECT_EQ(table["probes"][2],
            (Json{{"name", "Nowhere"}, {"reason", "no surface of the scene is there"}}));

  const Outcome text = probe(json, {"--named", "all"});
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(text.out.find("PROBE"), 0u) << text.out;
  EXPECT_NE(text.out.find("Nowhere: no surface of the scene is there"), std::string::npos);

  EXPECT_EQ(probe(json, {"--named", "all", "-o", folder.file("out")}).status, 0);
  EXPECT_EQ(Json::parse(contentOf(folder.path() / "out/probes.json")), table);
  const std::string csv = contentOf(folder.path() / "out/probes.csv");
  EXPECT_EQ(csv.find("name,x,y,z,receiver,truth,pcf,pcf error,vsm,"), 0u) << csv;
  EXPECT_NE(csv.find("\n\"a, \"\"b\"\"\","), std::string::npos) << csv;
}

TEST_F(NamedProbes, TexelsOfADepthMapAreProbedByName) {
  writeMap(folder.file("m.exr"), smallMap());
  Json json{{"format", "umbrascope-session/1"},
            {"source", {{"depth", "m.exr"}}},
            {"probes",
             {{{"name", "Edge"}, {"texel", {8, 9}}, {"receiver", 0.7}},
              {{"name", "Middle"}, {"texel", {12, 4}}},
              {{"name", "Outside"}, {"texel", {24, 4}}}}}};
  Json edge = probed(json, {"--texel", "8,9", "--receiver", "0.7"});
  edge["name"] = "Edge";
  EXPECT_EQ(probed(json, {"--named", "Edge"}), edge);
  Json middle = probed(json, {"--texel", "12,4", "--receiver", "0.5"});
  const Json table = probed(json, {"--named", "all"});
  EXPECT_EQ(table["source"], edge["source"]);
  EXPECT_EQ(table["probes"][1]["techniques"], middle["techniques"]);
  EXPECT_EQ(table["probes"][2]["reason"],
            "24,4 is outside the map of 24x17 texels, which count from 0");
  EXPECT_EQ(probed(json, {"--named", "Edge", "--receiver", "0.25"})["receiver"], 0.25);
  expectError(2, "--named: 24,4 is outside the map", probe(json, {"--named", "Outside"}));
}

TEST_F(NamedProbes, TheSameSceneOrFileNamedAgainKeepsThem) {
  const Json spot = probed(session("two-planes", Json::array()), {"--pixel", "worst"});
  const Json kept = session("two-planes", {{{"name", "Spot"}, {"point", spot["world"]}}});
  EXPECT_EQ(probed(kept, {"--scene", "two-planes", "--named", "all"}),
            probed(kept, {"--named", "all"}));
  writeMap(folder.file("m.exr"), smallMap());
  writeMap(folder.file("other.exr"), smallMap());
  const Json onFile{{"format", "umbrascope-session/1"},
                    {"source", {{"depth", "m.exr"}}},
                    {"probes", {{{"name", "Edge"}, {"texel", {8, 9}}, {"receiver", 0.7}}}}};
  const std::string again = (folder.path() / "." / "m.exr").string();
  EXPECT_EQ(probed(onFile, {"--depth", again, "--named", "Edge"}),
            probed(onFile, {"--named", "Edge"}));
  expectError(2, "--named: the session has no saved probes",
              probe(onFile, {"--depth", folder.file("other.exr"), "--named", "Edge"}));
}

TEST_F(NamedProbes, TheOneThatTheSessionIsAtNeedsNoName) {
  const Json spot = probed(session("two-planes", Json::array()), {"--pixel", "worst"});
  Json json = session("two-planes", {{{"name", "Spot"}, {"point", spot["world"]}}});
  json["probe"] = {0, 0};  // a pixel of a picture that did not show the point
  json["keptProbe"] = "Spot";
  EXPECT_EQ(probed(json, {}), spot);
}

TEST_F(NamedProbes, NamesThatThereAreNotAreRefused) {
  const Json json = session("two-planes", {{{"name", "Spot"}, {"point", {0, 0, 0}}},
                                           {{"name", "Bench"}, {"point", {0, 0, 0}}}});
  expectError(2, "--named: there is no probe 'Sport'; there are Spot, Bench, and all",
              probe(json, {"--named", "Sport"}));
  expectError(2, "--pixel: excludes --named", probe(json, {"--named", "Spot", "--pixel", "1,1"}));
  expectError(2, "--named: the session has no saved probes",
              probe(session("two-planes", Json::array()), {"--named", "all"}));
  // Another scene has other surfaces.
  expectError(2, "--named: the session has no saved probes",
              probe(json, {"--scene", "three-planes", "--named", "all"}));
}

}  // namespace
}  // namespace umbra::cli

// compare --surfaces: the error on the scene's surfaces, as numbers and as meshes.
#include <gtest/gtest.h>

#include "datasets/meshes/MeshFile.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

Arguments compare(const Arguments& more) {
  Arguments arguments{"compare", "--scene", "three-planes", "--size", "64x48", "--map-size", "128"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void expectAddsUp(const Json& surfaces) {
  double area = 0.0, bleedingArea = 0.0, bleeding = 0.0;
  std::size_t faces = 0;
  for (const Json& object : surfaces["objects"]) {
    area += object["area"].get<double>();
    bleedingArea += object["bleedingArea"].get<double>();
    bleeding += object["meanBleeding"].get<double>() * object["area"].get<double>();
    faces += object["faces"].get<std::size_t>();
  }
  EXPECT_NEAR(area, surfaces["area"], 1e-9);
  EXPECT_NEAR(bleedingArea, surfaces["bleedingArea"], 1e-9);
  EXPECT_NEAR(bleeding, surfaces["meanBleeding"].get<double>() * surfaces["area"].get<double>(),
              1e-9);
  EXPECT_EQ(faces, surfaces["faces"]);
}

TEST(Surfaces, TheReceiverOfThreePlanesBleeds) {
  const Json rows =
      run(compare({"--technique", "vsm,pcf", "--surfaces", "vtp", "--json"})).json()["techniques"];
  const Json &vsm = rows[0]["surfaces"], &pcf = rows[1]["surfaces"];
  expectAddsUp(vsm);
  EXPECT_EQ(pcf["bleedingArea"], 0.0);
  EXPECT_EQ(pcf["meanBleeding"], 0.0);
  EXPECT_TRUE(pcf["worst"].is_null());
  EXPECT_EQ(pcf["area"], vsm["area"]);
  EXPECT_EQ(pcf["shadowedArea"], vsm["shadowedArea"]);
  EXPECT_EQ(vsm["edge"], 4.0);
  const Json& c = vsm["objects"][2];
  ASSERT_EQ(c["name"], "C");
  // The area is that of C's upper side, 4 × 4, and of its edges, which the light only grazes. The
  // part under B, 3 × 2.6, and a part that A adds beyond B's front edge lie in shadow.
  EXPECT_NEAR(c["area"], 16.0, 0.01);
  EXPECT_GT(c["shadowedArea"], 3.0 * 2.6 - 0.5);
  EXPECT_GT(c["bleedingArea"], 1.0);
  EXPECT_LT(c["bleedingArea"], c["shadowedArea"].get<double>() + 1.0);
  EXPECT_GT(c["worst"]["error"], 0.1);
  EXPECT_LT(c["worst"]["error"], 0.75);
  EXPECT_NEAR(c["worst"]["position"][1], 3.2 * (1.02 - 1.04 * 0.94), 1e-5);
}

TEST(Surfaces, AreWrittenAsMeshes) {
  const TemporaryFolder folder;
  for (const char* format : {"vtp", "ply"}) {
    const Outcome outcome = run(
        compare({"--technique", "vsm,esm", "--surfaces", format, "-o", folder.path().string()}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  const Json rows = Json::parse(contentOf(folder.file("compare.json")))["techniques"];
  for (const char* id : {"vsm", "esm"}) {
    const std::size_t faces = rows[std::string(id) == "esm"]["surfaces"]["faces"];
    const std::string stem = folder.file("bleeding-" + std::string(id));
    EXPECT_EQ(readMeshFile(stem + ".ply").triangles.size(), faces);
    const std::string vtp = contentOf(stem + ".vtp");
    EXPECT_EQ(vtp.find("<?xml"), 0u);
    EXPECT_NE(vtp.find("NumberOfPolys=\"" + std::to_string(faces) + "\""), std::string::npos);
    EXPECT_NE(vtp.find("Name=\"bleeding\""), std::string::npos);
  }
  EXPECT_EQ(contentOf(folder.file("compare.csv")).find("surfaces"), std::string::npos);
}

// A finer mesh and a coarser one sum up the same integral.
TEST(Surfaces, AreasDoNotDependOnTheMesh) {
  const auto surfaces = [](const char* edge) {
    return run(compare(
                   {"--technique", "vsm", "--surfaces", "ply", "--surface-edge", edge, "--json"}))
        .json()["techniques"][0]["surfaces"];
  };
  const Json fine = surfaces("1"), coarse = surfaces("3");
  EXPECT_GT(fine["faces"], 4 * coarse["faces"].get<std::size_t>());
  // The error is at most that of the faces on the border of what is summed: C's border of 16, and
  // the ground's border of the map's width, 4.1; each face is as wide as an edge of 3 · 4.1 / 128.
  const double border = (16.0 + 4 * 4.1) * 3 * 4.1 / 128;
  EXPECT_NEAR(fine["area"], coarse["area"], border);
  EXPECT_NEAR(fine["shadowedArea"], coarse["shadowedArea"], border);
}

TEST(Surfaces, AreInTheTextWhenAskedFor) {
  const Outcome text = run(compare({"--technique", "vsm", "--surfaces", "vtp"}));
  EXPECT_NE(text.out.find("BLEEDING AREA"), std::string::npos) << text.out;
  const Json plain = run(compare({"--technique", "vsm", "--json"})).json();
  EXPECT_FALSE(plain["techniques"][0].contains("surfaces"));
}

void expectRefusal(const Arguments& arguments, const std::string& text) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
}

TEST(Surfaces, WhatCannotBeIsRefused) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  expectRefusal(compare({"--surfaces", "obj"}), "--surfaces: 'obj' is neither vtp nor ply");
  expectRefusal(compare({"--surface-edge", "2"}), "--surface-edge: only goes with --surfaces");
  expectRefusal(compare({"--surfaces", "vtp", "--surface-edge", "0.1"}), "from 0.5 to 256");
  expectRefusal(compare({"--surfaces", "vtp", "--cascades", "2"}), "take one map");
  expectRefusal(compare({"--surfaces", "vtp", "--filter", "anisotropic"}), "take bilinear");
  expectRefusal(compare({"--surfaces", "vtp", "--filter", "sat", "--technique", "vsm"}),
                "sat-size footprint");
  expectRefusal(
      {"compare", "--depth", folder.file("m.exr"), "--receiver", "0.5", "--surfaces", "vtp"},
      "--surfaces: a depth map has none");
}

}  // namespace
}  // namespace umbra::cli

#include "datasets/session/file/SessionFile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "datasets/session/file/SessionFileCheck.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class SessionFileTest : public testing::Test {
 protected:
  SessionFileTest() { fs::create_directories(folder_); }
  ~SessionFileTest() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::temp_directory_path() / ("umbra-session-" + std::to_string(getpid()));
};

TEST_F(SessionFileTest, EverythingSurvivesTheWayThereAndBack) {
  const Workspace workspace = unusualWorkspace();
  EXPECT_EQ(workspaceFromText(written(workspace), "s.json"), workspace);
  EXPECT_EQ(workspaceFromText(written(Workspace{}), "s.json"), Workspace{});
}

TEST_F(SessionFileTest, AbsentKeysHaveTheirDefaults) {
  EXPECT_EQ(workspaceFromText(R"({"format": "umbrascope-session/1"})", "s.json"), Workspace{});
}

TEST_F(SessionFileTest, DepthAndMeshSourcesSurvive) {
  Workspace depth;
  depth.shared.source = {SourceKind::DepthFile, "m.exr", "Z", -1.5, 40.0, {}};
  depth.shared.probes = {{"a", {}, Pixel{0, 16383}, {}}, {"b", {}, Pixel{7, 0}, 1.0}};
  EXPECT_EQ(workspaceFromText(written(depth), "s.json"), depth);
  Workspace mesh;
  mesh.shared.source = {SourceKind::MeshFile, "fan.ply", "", 0.0, 1.0, {}};
  EXPECT_EQ(workspaceFromText(written(mesh), "s.json"), mesh);
}

TEST_F(SessionFileTest, ErrorsNameFileAndKey) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"kernel": {"radius": 200}})")),
            "s.json: frame.kernel.radius: 200 is not right, it takes a whole number from 0 to 64");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"kernel": {"radios": 2}})")),
            "s.json: frame.kernel.radios: there is no such key; did you mean 'radius'?");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"format": "hafl"})")),
            "s.json: frame.format: 'hafl' is none of unorm8, unorm16, half, float, double");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("parameters": {"vsm": {"min-varianse": 1e-5}})")),
            "s.json: parameters.vsm.min-varianse: there is no parameter 'min-varianse'; did you "
            "mean 'min-variance'?");
  EXPECT_NE(sessionErrorOf(sessionWith(R"("parameters": {"esm": {"exponent": 1e9}})"))
                .find("s.json: parameters.esm.exponent: "),
            std::string::npos);
  EXPECT_NE(sessionErrorOf(sessionWith(R"("light": {"position": [1, 2]})"))
                .find("s.json: light.position: [1,2] is not right"),
            std::string::npos);
  EXPECT_NE(sessionErrorOf(sessionWith(R"("probe": [1.5, 2])")).find("s.json: probe: "),
            std::string::npos);
  EXPECT_NE(sessionErrorOf(sessionWith(R"("sice": [640, 480])")).find("s.json: sice: "),
            std::string::npos);
  EXPECT_NE(
      sessionErrorOf(sessionWith(R"("source": {"scene": "a", "mesh": "b"})")).find("exactly one"),
      std::string::npos);
}

TEST_F(SessionFileTest, NamesAreRefusedUnderTheirKey) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("technique": "vsn")")),
            "s.json: technique: there is no 'vsn'; did you mean 'vsm'?");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"kernel": {"shape": "Box"}})")),
            "s.json: frame.kernel.shape: 'Box' is none of none, box, gaussian");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"filter": "mip"})")),
            "s.json: frame.filter: 'mip' is none of point, bilinear, trilinear, anisotropic, sat");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"sat": {"size": "wide"}})")),
            "s.json: frame.sat.size: 'wide' is none of footprint, distance, fixed");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"sat": {"precision": "half"}})")),
            "s.json: frame.sat.precision: 'half' is none of centred, integer, plain");
}

TEST_F(SessionFileTest, MapsAndCascadesBeyondTheirRangesAreRefused) {
  const auto frameError = [](const std::string& member) {
    return sessionErrorOf(sessionWith("\"frame\": {" + member + "}"));
  };
  for (const char* samples : {"1", "2", "4", "8"})
    EXPECT_EQ(frameError("\"msaa\": " + std::string(samples)), "no error");
  EXPECT_EQ(frameError("\"msaa\": 3"), "s.json: frame.msaa: 3 is not right, it takes 1, 2, 4 or 8");
  EXPECT_EQ(frameError("\"msaa\": 16"),
            "s.json: frame.msaa: 16 is not right, it takes 1, 2, 4 or 8");
  EXPECT_EQ(frameError("\"anisotropy\": 17"),
            "s.json: frame.anisotropy: 17 is not right, it takes a whole number from 1 to 16");
  EXPECT_EQ(frameError("\"cascades\": {\"count\": 5}"),
            "s.json: frame.cascades.count: 5 is not right, it takes a whole number from 1 to 4");
  for (const char* member : {"splitLambda\": 1.5", "seam\": 0.6", "split\": 1"})
    EXPECT_EQ(frameError("\"cascades\": {\"" + std::string(member) + "}")
                  .find("s.json: frame.cascades.s"),
              0u)
        << member;
  EXPECT_EQ(frameError("\"sat\": {\"distance\": -1}").find("s.json: frame.sat.distance: "), 0u);
  EXPECT_EQ(frameError(R"("cascades": {"frozen": {"position": [0,0,0], "target": [0,0,0]}})")
                .find("s.json: frame.cascades.frozen: "),
            0u);
}

// As files were written before there were mip levels, summed areas, samples and cascades.
TEST_F(SessionFileTest, FilesOfTheFirstVersionStillLoad) {
  const Workspace workspace = workspaceFromText(
      sessionWith(R"("frame": {"mapSize": 256, "format": "half", "filter": "point",
        "view": "error", "kernel": {"shape": "none", "radius": 1, "sigma": 0},
        "bias": {"constant": 0, "slope": 0, "receiverPlane": false, "cullFrontFaces": true}})"),
      "s.json");
  FrameSettings expected;
  expected.map.size = 256;
  expected.map.format = StorageFormat::Half;
  expected.kernel = {KernelShape::None, 1};
  expected.read.filter = ReadFilter::Point;
  expected.bias = {0.0, 0.0, false, true};
  expected.view = ViewMode::Error;
  EXPECT_EQ(workspace.shared.frame, expected);
}

TEST_F(SessionFileTest, NumbersBeyondTheirTypeAreRefused) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("receiver": 1e400)")),
            "s.json: cannot be read: number overflow parsing '1e400'");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("probe": [1e300, 2])")),
            "s.json: probe: [1e+300,2] should be two whole numbers from 0 to 16383");
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("size": [15, 200])")),
      "s.json: size: [15,200] is not right, it takes WIDTHxHEIGHT, in a file [WIDTH, HEIGHT], "
      "each a whole number from 16 to 16384");
  for (const char* sigma : {"1e-200", "0.0099", "-1", "1000.5"})
    EXPECT_EQ(
        sessionErrorOf(sessionWith(R"("frame": {"kernel": {"sigma": )" + std::string(sigma) + "}}"))
            .find("s.json: frame.kernel.sigma: "),
        0u)
        << sigma;
  for (const char* sigma : {"0", "0.01", "1000"})
    EXPECT_EQ(sessionErrorOf(
                  sessionWith(R"("frame": {"kernel": {"sigma": )" + std::string(sigma) + "}}")),
              "no error");
}

TEST_F(SessionFileTest, LightsAndCamerasWithoutAPictureAreRefused) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("light": {"position": [1, 2, 3], "target": [1, 2, 3]})")),
            "s.json: light: position and target are the same point, they should differ");
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("light": {"colour": [1, -1, 1]})")),
      "s.json: light.colour: [1,-1,1] is not right, it takes X,Y,Z, in a file [X, Y, Z], each "
      "a number from 0 to 1");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("camera": {"up": [0, 0, 0]})")),
            "s.json: camera: the up vector has no length, it should point up");
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("camera": {"position": [1, 2, 3], "target": [1, 2, 3]})")),
      "s.json: camera: position and target are the same point, they should differ");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("camera": {"viewAngle": 121})")),
            "s.json: camera.viewAngle: 121 is not right, it takes a number from 1 to 120");
}

TEST_F(SessionFileTest, ParametersThatContradictEachOtherAreRefused) {
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("parameters": {"lvsm": {"splits": [0.2, 0.5], "layers": 7}})")),
      "s.json: parameters.lvsm.layers: '7' contradicts the other parameters, which make it "
      "'3'");
  EXPECT_EQ(sessionErrorOf(sessionWith(
                R"("parameters": {"lvsm": {"placement": "lloyd", "splits": [0.2, 0.5]}})")),
            "s.json: parameters.lvsm.placement: 'lloyd' contradicts the other parameters, which "
            "make it 'manual'");
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("parameters": {"lvsm": {"splits": [0.2, 0.5], "layers": 3}})")),
      "no error");
}

TEST_F(SessionFileTest, WhatIsNoSessionIsRefused) {
  EXPECT_EQ(sessionErrorOf("[]"), "s.json: [] should be an object {…}");
  EXPECT_NE(sessionErrorOf("{}").find("is no session"), std::string::npos);
  EXPECT_NE(sessionErrorOf(R"({"format": "umbrascope-session/2"})").find("is no session"),
            std::string::npos);
  const std::string whole = written(unusualWorkspace());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
    EXPECT_NE(sessionErrorOf(whole.substr(0, length)).find("is not JSON"), std::string::npos)
        << length;
}

TEST_F(SessionFileTest, AKeyThatIsThereTwiceIsRefused) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("frame": {"kernel": {"radius": 3, "radius": 5}})")),
            "s.json: frame.kernel.radius: is there twice, one has to go");
  EXPECT_EQ(
      sessionErrorOf(sessionWith(R"("technique": "vsm", "size": [64, 64], "technique": "esm")")),
      "s.json: technique: is there twice, one has to go");
  // In a list the element is named as everywhere, whatever stands before it.
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("probes": [{"name": "a", "point": [1, 2, 3]}, 7, [8, {}],
                                               {"name": "b", "point": [1, 2], "name": "c"}])")),
            "s.json: probes[4].name: is there twice, one has to go");
  EXPECT_EQ(sessionErrorOf(R"([[], [{}, {"a": [1, 2], "a": 3}]])"),
            "s.json: [2][2].a: is there twice, one has to go");
  // One name in two objects is no repetition.
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("parameters": {"vsm": {"bleed-reduction": 0.1},
                                                  "msm": {"bleed-reduction": 0.1}})")),
            "no error");
}

TEST_F(SessionFileTest, PathsAreRelativeToTheFile) {
  Workspace workspace;
  workspace.shared.source = {
      SourceKind::MeshFile, (folder_ / "meshes" / "fan.ply").string(), "", 0.0, 1.0, {}};
  writeWorkspace(workspace, folder_ / "s.json");
  std::ifstream stream(folder_ / "s.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(text.find("\"meshes/fan.ply\""), std::string::npos);
  EXPECT_EQ(readWorkspace(folder_ / "s.json"), workspace);
}

TEST_F(SessionFileTest, AFileThatIsNotThereIsNamed) {
  try {
    readWorkspace(folder_ / "none.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none.json"), std::string::npos);
  }
}

// The file has every key, in the order in which version 0.1 wrote them.
TEST_F(SessionFileTest, ASessionOfVersion01IsReadAsItWasMeant) {
  Workspace meant = unusualWorkspace();
  meant.shared.frame.errorRange = 1.0;  // which was not to be set
  EXPECT_EQ(readWorkspace(fs::path(UMBRASCOPE_EXAMPLES) / "version-0.1.json"), meant);
}

}  // namespace
}  // namespace umbra

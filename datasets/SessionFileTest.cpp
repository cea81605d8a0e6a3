#include "datasets/SessionFile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "datasets/PaneEditing.h"
#include "filters/core/Error.h"

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

// Every member away from its default.
Session unusualSession() {
  Session session;
  session.source.name = "three-planes";
  session.source.parameters = {{"a", 0.1}, {"b", 0.5}};
  session.light = Light{LightKind::Spot, {1, 2, 3}, {0.1, 0.2, 0.3}, 45.5, {1, 0.9, 0.8}, 2.5};
  session.camera = Camera{{4, 5, 6}, {1, 0, 1}, {0, 0, 1}, 42.0};
  session.frame.map = {
      512, StorageFormat::Half, 4, {3, 0.75, 0.2, Camera{{7, 8, 9}, {1, 2, 3}, {0, 0, 1}, 33.0}}};
  session.frame.kernel = {KernelShape::Gaussian, 7, 2.25};
  session.frame.read = {ReadFilter::SummedArea, 5, SatSize::Distance, SatPrecision::Plain, 12.5};
  session.frame.bias = {1e-3, 2.0, false, true};
  session.frame.view = ViewMode::Error;
  session.technique = "power-cdf";
  session.parameters = {{"vsm", {{"min-variance", 1.0 / 3.0 * 1e-3}}},
                        {"csm", {{"terms", 8}, {"mode", std::string("scale")}}}};
  session.comparison = {ComparisonMode::Wipe, linkedPanes({"csm", "power-cdf", "msm"}), 1, 0.375};
  session.width = 640;
  session.height = 480;
  session.probe = Pixel{17, 23};
  session.receiver = 0.1 + 0.2;
  session.probes = {{"Bench", Eigen::Vector3d(1.0 / 3.0, -2, 0.1), {}, 0.25},
                    {"Ast über \"Bank\"", Eigen::Vector3d(0, 1e8, 0), {}, {}}};
  session.keptProbe = "Bench";
  return session;
}

// The message of the error that reading `text` ends in.
std::string errorOf(const std::string& text) {
  try {
    sessionFromText(text, "s.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

std::string sessionWith(const std::string& members) {
  return R"({"format": "umbrascope-session/1", )" + members + "}";
}

TEST_F(SessionFileTest, EverythingSurvivesTheWayThereAndBack) {
  const Session session = unusualSession();
  EXPECT_EQ(sessionFromText(sessionToText(session), "s.json"), session);
  EXPECT_EQ(sessionFromText(sessionToText(Session{}), "s.json"), Session{});
}

TEST_F(SessionFileTest, AbsentKeysHaveTheirDefaults) {
  EXPECT_EQ(sessionFromText(R"({"format": "umbrascope-session/1"})", "s.json"), Session{});
}

TEST_F(SessionFileTest, DepthAndMeshSourcesSurvive) {
  Session depth;
  depth.source = {SourceKind::DepthFile, "m.exr", "Z", -1.5, 40.0, {}};
  depth.probes = {{"a", {}, Pixel{0, 16383}, {}}, {"b", {}, Pixel{7, 0}, 1.0}};
  EXPECT_EQ(sessionFromText(sessionToText(depth), "s.json"), depth);
  Session mesh;
  mesh.source = {SourceKind::MeshFile, "fan.ply", "", 0.0, 1.0, {}};
  EXPECT_EQ(sessionFromText(sessionToText(mesh), "s.json"), mesh);
}

TEST_F(SessionFileTest, ErrorsNameFileAndKey) {
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"radius": 200}})")),
            "s.json: frame.kernel.radius: 200 is not right, it takes a whole number from 0 to 64");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"radios": 2}})")),
            "s.json: frame.kernel.radios: there is no such key; did you mean 'radius'?");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"format": "hafl"})")),
            "s.json: frame.format: 'hafl' is none of unorm8, unorm16, half, float, double");
  EXPECT_EQ(errorOf(sessionWith(R"("parameters": {"vsm": {"min-varianse": 1e-5}})")),
            "s.json: parameters.vsm.min-varianse: there is no parameter 'min-varianse'; did you "
            "mean 'min-variance'?");
  EXPECT_NE(errorOf(sessionWith(R"("parameters": {"esm": {"exponent": 1e9}})"))
                .find("s.json: parameters.esm.exponent: "),
            std::string::npos);
  EXPECT_NE(errorOf(sessionWith(R"("light": {"position": [1, 2]})"))
                .find("s.json: light.position: [1,2] is not right"),
            std::string::npos);
  EXPECT_NE(errorOf(sessionWith(R"("probe": [1.5, 2])")).find("s.json: probe: "),
            std::string::npos);
  EXPECT_NE(errorOf(sessionWith(R"("sice": [640, 480])")).find("s.json: sice: "),
            std::string::npos);
  EXPECT_NE(errorOf(sessionWith(R"("source": {"scene": "a", "mesh": "b"})")).find("exactly one"),
            std::string::npos);
}

TEST_F(SessionFileTest, NamesAreRefusedUnderTheirKey) {
  EXPECT_EQ(errorOf(sessionWith(R"("technique": "vsn")")),
            "s.json: technique: there is no 'vsn'; did you mean 'vsm'?");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"shape": "Box"}})")),
            "s.json: frame.kernel.shape: 'Box' is none of none, box, gaussian");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"filter": "mip"})")),
            "s.json: frame.filter: 'mip' is none of point, bilinear, trilinear, anisotropic, sat");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"sat": {"size": "wide"}})")),
            "s.json: frame.sat.size: 'wide' is none of footprint, distance, fixed");
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"sat": {"precision": "half"}})")),
            "s.json: frame.sat.precision: 'half' is none of centred, integer, plain");
}

TEST_F(SessionFileTest, MapsAndCascadesBeyondTheirRangesAreRefused) {
  const auto frameError = [](const std::string& member) {
    return errorOf(sessionWith("\"frame\": {" + member + "}"));
  };
  for (const char* samples : {"1", "2", "4", "8"})
    EXPECT_EQ(frameError("\"msaa\": " + std::string(samples)), "no error");
  EXPECT_EQ(frameError("\"msaa\": 3"), "s.json: frame.msaa: 3 is not right, it takes 1, 2, 4 or 8");
  EXPECT_EQ(frameError("\"msaa\": 16"),
            "s.json: frame.msaa: 16 is not right, it takes a whole number from 1 to 8");
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
  const Session session =
      sessionFromText(sessionWith(R"("frame": {"mapSize": 256, "format": "half", "filter": "point",
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
  EXPECT_EQ(session.frame, expected);
}

TEST_F(SessionFileTest, NumbersBeyondTheirTypeAreRefused) {
  EXPECT_EQ(errorOf(sessionWith(R"("receiver": 1e400)")),
            "s.json: cannot be read: number overflow parsing '1e400'");
  EXPECT_EQ(errorOf(sessionWith(R"("probe": [1e300, 2])")),
            "s.json: probe: [1e+300,2] should be two whole numbers from 0 to 16383");
  EXPECT_EQ(errorOf(sessionWith(R"("size": [15, 200])")),
            "s.json: size: [15,200] should be two whole numbers from 16 to 16384");
  for (const char* sigma : {"1e-200", "0.0099", "-1", "1000.5"})
    EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"sigma": )" + std::string(sigma) + "}}"))
                  .find("s.json: frame.kernel.sigma: "),
              0u)
        << sigma;
  for (const char* sigma : {"0", "0.01", "1000"})
    EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"sigma": )" + std::string(sigma) + "}}")),
              "no error");
}

TEST_F(SessionFileTest, LightsAndCamerasWithoutAPictureAreRefused) {
  EXPECT_EQ(errorOf(sessionWith(R"("light": {"position": [1, 2, 3], "target": [1, 2, 3]})")),
            "s.json: light: position and target are the same point, they should differ");
  EXPECT_EQ(errorOf(sessionWith(R"("light": {"colour": [1, -1, 1]})")),
            "s.json: light: the colour is -1, it should be from 0 to 1");
  EXPECT_EQ(errorOf(sessionWith(R"("camera": {"up": [0, 0, 0]})")),
            "s.json: camera: the up vector has no length, it should point up");
  EXPECT_EQ(errorOf(sessionWith(R"("camera": {"position": [1, 2, 3], "target": [1, 2, 3]})")),
            "s.json: camera: position and target are the same point, they should differ");
  EXPECT_EQ(errorOf(sessionWith(R"("camera": {"viewAngle": 121})")),
            "s.json: camera.viewAngle: 121 is not right, it takes a number from 1 to 120");
}

TEST_F(SessionFileTest, ComparisonsWithoutPanesAreRefused) {
  EXPECT_EQ(errorOf(sessionWith(R"("compare": {"mode": "half"})")),
            "s.json: compare.mode: 'half' is not right, it takes single, wipe or grid");
  EXPECT_EQ(errorOf(sessionWith(R"("compare": {"techniques": ["vsm", "vsmm"]})")),
            "s.json: compare.techniques[2]: there is no technique vsmm");
  EXPECT_EQ(errorOf(sessionWith(R"("compare": {"techniques": ["vsm", "vsm"]})")),
            "s.json: compare.techniques[2]: has vsm twice, each is compared once unless \"panes\" "
            "set it apart");
  EXPECT_EQ(errorOf(sessionWith(R"("compare": {"techniques": ["vsm"]})")),
            "s.json: compare.techniques: there are 1, two to six are compared");
  EXPECT_EQ(errorOf(sessionWith(R"("compare": {"wipe": 2})")),
            "s.json: compare.wipe: 2 is not right, it takes a number from 0 to 1");
}

TEST_F(SessionFileTest, KeptProbesThatCannotBeAreRefused) {
  const auto probesError = [](const std::string& list, const std::string& more = "") {
    return errorOf(sessionWith(more + "\"probes\": " + list));
  };
  const std::string at = R"("point": [1, 2, 3]})", first = R"([{"name": "a", )" + at;
  EXPECT_EQ(probesError(first + "]"), "no error");
  EXPECT_EQ(probesError("{}"), "s.json: probes: {} is not right, it takes a list […]");
  EXPECT_EQ(probesError(first + ", 7]"), "s.json: probes[2]: 7 should be an object {…}");
  EXPECT_EQ(probesError("[{" + at + "]"), "s.json: probes[1].name: a probe needs a name");
  EXPECT_EQ(probesError(R"([{"name": "  ", )" + at + "]"),
            "s.json: probes[1].name: a probe needs a name");
  EXPECT_EQ(probesError(R"([{"name": 3, )" + at + "]"),
            "s.json: probes[1].name: 3 is not right, it takes a text");
  EXPECT_EQ(probesError(first + R"(, {"name": "a", )" + at + "]"),
            "s.json: probes[2].name: there is a probe 'a' already");
  EXPECT_EQ(probesError(R"([{"name": "all", )" + at + "]"),
            "s.json: probes[1].name: 'all' stands for every probe, give it another name");
  EXPECT_EQ(probesError(R"([{"name": "a\tb", )" + at + "]"),
            "s.json: probes[1].name: the name should be one line without tabs");
  EXPECT_EQ(probesError("[{\"name\": \"" + std::string(61, 'x') + "\", " + at + "]"),
            "s.json: probes[1].name: the name is 61 bytes long, it should be at most 60");
  EXPECT_EQ(probesError(R"([{"name": "a", "point": [1, 2]}])"),
            "s.json: probes[1].point: [1,2] is not right, it takes three numbers [x, y, z]");
  EXPECT_EQ(probesError(R"([{"name": "a", "point": [1, 2, 2e9]}])"),
            "s.json: probes[1].point: has a coordinate beyond 1e+09, which is out of reach");
  EXPECT_EQ(probesError(R"([{"name": "a", "texel": [1, 2]}])"),
            "s.json: probes[1]: on a scene needs a 'point' and no 'texel'");
  EXPECT_EQ(probesError(R"([{"name": "a", "receiver": 2, )" + at + "]"),
            "s.json: probes[1].receiver: 2 is not right, it takes a number from 0 to 1");
  EXPECT_EQ(probesError(R"([{"name": "a", "spot": 2, )" + at + "]"),
            "s.json: probes[1].spot: there is no such key");
  std::string many;
  for (int i = 1; i <= 13; ++i)
    many += (i > 1 ? ", " : "") + ("{\"name\": \"" + std::to_string(i)) + "\", " + at;
  EXPECT_EQ(probesError("[" + many + "]"),
            "s.json: probes[13]: is one too many, at most 12 are kept");
  const std::string onFile = R"("source": {"depth": "m.exr"}, )";
  EXPECT_EQ(probesError(first + "]", onFile),
            "s.json: probes[1]: on a depth file needs a 'texel' and no 'point'");
  for (const char* texel : {"[1]", "[1, 0.5]", "[-1, 0]", "[0, 16384]", "3"})
    EXPECT_EQ(probesError(R"([{"name": "a", "texel": )" + std::string(texel) + "}]", onFile)
                  .find("s.json: probes[1].texel: "),
              0u)
        << texel;
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "b")"),
            "s.json: keptProbe: there is no probe 'b' among 'probes'");
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "a")"),
            "s.json: keptProbe: needs a 'probe', the pixel or texel it is at");
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "a", "probe": [0, 0])"), "no error");
}

// Two panes of one technique, of which the active one has everything of its own.
Session comparingSettings() {
  Session session = unusualSession();
  session.technique = "csm";
  session.frame.read.filter = ReadFilter::Bilinear;
  session.comparison = {ComparisonMode::Grid, linkedPanes({"csm", "power-cdf", "msm"}), 0, 0.375};
  setOwn(session, 1, PaneSetting::Format, true);
  session.comparison.panes[1].own.format = StorageFormat::Unorm16;
  duplicatePane(session, 0);
  session.frame.kernel = {KernelShape::Box, 12, 0.0};
  session.frame.read = {ReadFilter::Anisotropic, 16, SatSize::Fixed, SatPrecision::Integer, 2.5};
  session.frame.bias = {0.0, 0.5, true, false};
  session.frame.map = {256, StorageFormat::Float, 1, {}};
  setParameters(session, "csm", {{"terms", 4}});
  return session;
}

TEST_F(SessionFileTest, SettingsOfPanesSurvive) {
  const Session session = comparingSettings();
  const Session read = sessionFromText(sessionToText(session), "s.json");
  EXPECT_EQ(read, session);
  for (std::size_t pane = 0; pane < session.comparison.panes.size(); ++pane)
    EXPECT_EQ(activated(read, pane).frame, activated(session, pane).frame) << pane;
  // Whichever of them is active.
  for (const std::size_t pane : {0u, 2u})
    EXPECT_EQ(sessionFromText(sessionToText(activated(session, pane)), "s.json"),
              activated(session, pane));
  Session fresh = unusualSession();
  fresh.comparison.mode = ComparisonMode::Grid;
  duplicatePane(fresh, 1);
  EXPECT_EQ(sessionFromText(sessionToText(fresh), "s.json"), fresh);
}

TEST_F(SessionFileTest, AFileHasWhatPanesShareAndWhatIsTheirOwn) {
  const auto json = toJson(comparingSettings());
  EXPECT_EQ(json.at("frame").at("kernel").at("radius"), 7);
  EXPECT_EQ(json.at("parameters").at("csm").at("terms"), 8);
  const auto& panes = json.at("compare").at("panes");
  EXPECT_EQ(panes.at(0).dump(), R"({"technique":"csm"})");
  EXPECT_EQ(panes.at(1).at("active"), true);
  EXPECT_EQ(panes.at(1).at("kernel").at("radius"), 12);
  EXPECT_EQ(panes.at(1).at("parameters").dump(), R"({"terms":4})");
  EXPECT_EQ(panes.at(2).dump(), R"({"technique":"power-cdf","format":"unorm16"})");
}

TEST_F(SessionFileTest, WhatAPaneDoesNotSayItShares) {
  const Session session = sessionFromText(
      sessionWith(R"("frame": {"mapSize": 512, "kernel": {"shape": "gaussian", "radius": 3}},
        "compare": {"mode": "grid", "panes": [
          {"technique": "vsm"}, {"technique": "vsm", "kernel": {"radius": 12}}]})"),
      "s.json");
  EXPECT_EQ(session.comparison.active, 0u);
  const Session second = activated(session, 1);
  EXPECT_EQ(second.frame.kernel, (Kernel{KernelShape::Gaussian, 12, 0.0}));
  EXPECT_EQ(second.frame.map.size, 512);
  EXPECT_FALSE(hasOwn(session.comparison.panes[1], PaneSetting::MapSize));
  EXPECT_FALSE(hasOwn(session.comparison.panes[1], PaneSetting::Parameters));
}

TEST_F(SessionFileTest, PanesThatCannotBeAreRefused) {
  const auto panesError = [](const std::string& panes) {
    return errorOf(sessionWith(R"("compare": {"panes": [)" + panes + "]}"));
  };
  const std::string vsm = R"({"technique": "vsm"}, )";
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsn"})"),
            "s.json: compare.panes[2].technique: there is no 'vsn'; did you mean 'vsm'?");
  EXPECT_EQ(panesError(vsm + R"({"kernel": {"radius": 2}})"),
            "s.json: compare.panes[2]: needs a \"technique\"");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "kernel": {"radius": 200}})"),
            "s.json: compare.panes[2].kernel.radius: 200 is not right, it takes a whole number "
            "from 0 to 64");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "parameters": {"bleed-reductoin": 0.3}})"),
            "s.json: compare.panes[2].parameters.bleed-reductoin: there is no parameter "
            "'bleed-reductoin'; did you mean 'bleed-reduction'?");
  EXPECT_EQ(panesError(vsm + R"({"technique": "lvsm",
                                 "parameters": {"splits": [0.2, 0.5], "layers": 7}})"),
            "s.json: compare.panes[2].parameters.layers: '7' contradicts the other parameters, "
            "which make it '3'");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "view": "error"})")
                .find("s.json: compare.panes[2].view: there is no such key"),
            0u);
  EXPECT_EQ(panesError(vsm + R"("msm")"),
            "s.json: compare.panes[2]: \"msm\" should be an object {…}");
  EXPECT_EQ(panesError(R"({"technique": "vsm"})"),
            "s.json: compare.panes: there are 1, two to six are compared");
  EXPECT_EQ(panesError(R"({"technique": "vsm", "active": true}, )" +
                       std::string(R"({"technique": "vsm", "active": true})")),
            "s.json: compare.panes[2].active: one before it is active, only one can be");
  EXPECT_EQ(panesError(vsm + R"({"technique": "msm", "active": true})"),
            "s.json: compare.panes[2]: should show vsm, which \"technique\" says");
  EXPECT_EQ(panesError(R"({"technique": "msm"}, {"technique": "esm"})"),
            "s.json: compare.panes: should show vsm, which \"technique\" says");
  EXPECT_EQ(errorOf(sessionWith(
                R"("compare": {"techniques": ["vsm", "msm"], "panes": [{"technique": "vsm"}]})")),
            "s.json: compare.panes[1]: \"techniques\" has the panes, it takes one of the two");
}

TEST_F(SessionFileTest, ParametersThatContradictEachOtherAreRefused) {
  EXPECT_EQ(errorOf(sessionWith(R"("parameters": {"lvsm": {"splits": [0.2, 0.5], "layers": 7}})")),
            "s.json: parameters.lvsm.layers: '7' contradicts the other parameters, which make it "
            "'3'");
  EXPECT_EQ(errorOf(sessionWith(
                R"("parameters": {"lvsm": {"placement": "lloyd", "splits": [0.2, 0.5]}})")),
            "s.json: parameters.lvsm.placement: 'lloyd' contradicts the other parameters, which "
            "make it 'manual'");
  EXPECT_EQ(errorOf(sessionWith(R"("parameters": {"lvsm": {"splits": [0.2, 0.5], "layers": 3}})")),
            "no error");
}

TEST_F(SessionFileTest, WhatIsNoSessionIsRefused) {
  EXPECT_EQ(errorOf("[]"), "s.json: [] should be an object {…}");
  EXPECT_NE(errorOf("{}").find("is no session"), std::string::npos);
  EXPECT_NE(errorOf(R"({"format": "umbrascope-session/2"})").find("is no session"),
            std::string::npos);
  const std::string whole = sessionToText(unusualSession());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
    EXPECT_NE(errorOf(whole.substr(0, length)).find("is not JSON"), std::string::npos) << length;
}

TEST_F(SessionFileTest, AKeyThatIsThereTwiceIsRefused) {
  EXPECT_EQ(errorOf(sessionWith(R"("frame": {"kernel": {"radius": 3, "radius": 5}})")),
            "s.json: frame.kernel.radius: is there twice, one has to go");
  EXPECT_EQ(errorOf(sessionWith(R"("technique": "vsm", "size": [64, 64], "technique": "esm")")),
            "s.json: technique: is there twice, one has to go");
  // One name in two objects is no repetition.
  EXPECT_EQ(errorOf(sessionWith(R"("parameters": {"vsm": {"bleed-reduction": 0.1},
                                                  "msm": {"bleed-reduction": 0.1}})")),
            "no error");
}

TEST_F(SessionFileTest, PathsAreRelativeToTheFile) {
  Session session;
  session.source = {
      SourceKind::MeshFile, (folder_ / "meshes" / "fan.ply").string(), "", 0.0, 1.0, {}};
  writeSession(session, folder_ / "s.json");
  std::ifstream stream(folder_ / "s.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(text.find("\"meshes/fan.ply\""), std::string::npos);
  EXPECT_EQ(readSession(folder_ / "s.json"), session);
}

TEST_F(SessionFileTest, AFileThatIsNotThereIsNamed) {
  try {
    readSession(folder_ / "none.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace umbra

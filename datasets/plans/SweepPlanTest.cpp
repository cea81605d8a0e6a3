#include "datasets/plans/SweepPlan.h"

#include <gtest/gtest.h>

#include <fstream>

#include "datasets/maps/ExrFile.h"
#include "datasets/plans/SweepCell.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

class SweepPlans : public testing::Test {
 protected:
  SweepPlans() {
    Image<float> map(4, 4);
    for (float& value : map.values()) value = 0.5f;
    writeExr(folder_ / "m.exr", {{"Z", map}}, {});
  }

  SweepPlan plan(const std::string& axes, const std::string& more = "",
                 const std::string& base = R"({"source": {"scene": "fence"}})") const {
    return sweepPlanFrom(
        R"({"format": "umbrascope-sweep/1", "base": )" + base + R"(, "axes": )" + axes + more + "}",
        "plan.json", folder_.path());
  }
  std::string refusal(const std::string& axes, const std::string& more = "",
                      const std::string& base = R"({"source": {"scene": "fence"}})") const {
    try {
      plan(axes, more, base);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_TRUE(std::string_view(error.what()).starts_with("plan.json")) << error.what();
      return error.what();
    }
    return "no error";
  }
  // "technique=vsm kernel.radius=1|…"
  static std::string cellsOf(const SweepPlan& plan) {
    std::string text;
    for (const SweepCell& cell : plan.cells) {
      if (!text.empty()) text += "|";
      std::string one;
      for (const auto& [setting, value] : cell)
        one += (one.empty() ? "" : " ") + setting + "=" + textOfValue(value);
      text += one;
    }
    return text;
  }

  const TemporaryFolder folder_;
};

TEST_F(SweepPlans, TheLastAxisChangesFastest) {
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "technique", "values": ["vsm", "esm"]},
                             {"setting": "kernel.radius", "range": [1, 3, 3]}])")),
            "technique=vsm kernel.radius=1|technique=vsm kernel.radius=2|technique=vsm "
            "kernel.radius=3|technique=esm kernel.radius=1|technique=esm kernel.radius=2|"
            "technique=esm kernel.radius=3");
}

TEST_F(SweepPlans, RangesHaveTheirEndsAndReadableStepsBetween) {
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "vsm.min-variance", "log": [1e-7, 1e-4, 4]}])")),
            "vsm.min-variance=1e-07|vsm.min-variance=1e-06|vsm.min-variance=1e-05|"
            "vsm.min-variance=0.0001");
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "kernel.sigma", "range": [0.1, 0.4, 4]}])")),
            "kernel.sigma=0.1|kernel.sigma=0.2|kernel.sigma=0.3|kernel.sigma=0.4");
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "kernel.radius", "range": [5, 9, 1]}])")),
            "kernel.radius=5");
}

TEST_F(SweepPlans, AxesAreSteppedTogetherAndUnderConditions) {
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "technique", "values": ["vsm", "hard"]},
                             {"zip": [{"setting": "map.size", "values": [64, 128]},
                                      {"setting": "kernel.radius", "values": [1, 2]}],
                              "when": {"technique": ["vsm"]}}])")),
            "technique=vsm map.size=64 kernel.radius=1|technique=vsm map.size=128 "
            "kernel.radius=2|technique=hard");
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "technique", "values": ["vsm", "esm"]},
                             {"setting": "kernel.radius", "values": [1, 2]}])",
                         R"(, "combine": "zip")")),
            "technique=vsm kernel.radius=1|technique=esm kernel.radius=2");
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "technique", "values": ["vsm", "esm"]},
                             {"setting": "kernel.radius", "values": [1, 2]}])",
                         R"(, "skip": [{"technique": "esm", "kernel.radius": [2]}])")),
            "technique=vsm kernel.radius=1|technique=vsm kernel.radius=2|technique=esm "
            "kernel.radius=1");
}

TEST_F(SweepPlans, ACellIsTheBaseWithWhatItSets) {
  const SweepPlan swept = plan(
      R"([{"setting": "scene", "values": ["car"]}, {"setting": "technique", "values": ["csm"]},
          {"setting": "csm.terms", "values": [4]}, {"setting": "light.intensity", "values": [2]},
          {"setting": "bias.receiver-plane", "values": [false]}])");
  const TechniqueCatalogue catalogue = allTechniques();
  const Session session = sessionOfCell(swept, 0, catalogue, {}, "plan.json");
  EXPECT_EQ(session.source.name, "car");
  EXPECT_EQ(session.technique, "csm");
  EXPECT_EQ(session.light->intensity, 2.0);
  EXPECT_FALSE(session.frame.bias.receiverPlane);
  EXPECT_EQ(techniqueOf(session, catalogue, "csm")->channels().size(), 8u);
}

TEST_F(SweepPlans, ACellSetsAScenesParametersAndTheProbe) {
  const std::string scene = R"({"setting": "scene", "values": ["two-planes"]}, )";
  const SweepPlan swept = plan("[" + scene + R"({"setting": "scene.occluder", "values": [0.25]},
                                 {"setting": "probe", "values": [[3, 4]]}])",
                               R"(, "measures": ["probe"])");
  const Session session = sessionOfCell(swept, 0, allTechniques(), {}, "plan.json");
  EXPECT_EQ(session.source.name, "two-planes");
  EXPECT_EQ(session.source.parameters.at("occluder"), 0.25);
  EXPECT_EQ(session.probe, (Pixel{3, 4}));
  const auto expectRefusal = [&](const std::string& axis, const char* part) {
    const std::string why = refusal("[" + scene + axis + "]");
    EXPECT_NE(why.find(part), std::string::npos) << why;
  };
  expectRefusal(R"({"setting": "scene.occluder", "values": [2]})", "from 0.02 to 0.9");
  expectRefusal(R"({"setting": "scene.pickets", "values": [9]})",
                "no parameter 'pickets'; there are occluder, receiver");
  expectRefusal(R"({"setting": "probe", "values": [3]})", "a pixel, [x, y]");
}

// A depth map is measured in double, unless somebody asks for a format.
TEST_F(SweepPlans, DepthMapsAreMeasuredInDouble) {
  const TechniqueCatalogue catalogue = allTechniques();
  const std::string axes = R"([{"setting": "depth", "values": ["m.exr"]}])";
  const auto formatOf = [&](const std::string& base) {
    return sessionOfCell(plan(axes, "", base), 0, catalogue, {}, "plan.json").frame.map.format;
  };
  EXPECT_EQ(formatOf(R"({"receiver": 0.5})"), StorageFormat::Double);
  EXPECT_EQ(formatOf(R"({"receiver": 0.5, "frame": {"format": "half"}})"), StorageFormat::Half);
}

TEST_F(SweepPlans, NameWhatIsWrong) {
  const auto holds = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  holds(refusal("[]"), "has no 'axes'");
  holds(refusal(R"([{"setting": "kernel.radius"}])"), "should have one of");
  holds(refusal(R"([{"values": [1]}])"), "has no 'setting'");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1], "log": [1, 2, 3]}])"),
        "should have one of");
  holds(refusal(R"([{"setting": "kernel.radius", "log": [0, 2, 3]}])"), "above 0");
  holds(refusal(R"([{"setting": "kernel.radius", "range": [1, 2]}])"), "[FROM, TO, COUNT]");
  holds(refusal(R"([{"setting": "kernel.radios", "values": [1]}])"), "kernel.radius");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1, 99]}])"), "cell 1: kernel.radius");
  holds(refusal(R"([{"setting": "vsm.variance", "values": [1]}])"), "min-variance");
  holds(refusal(R"([{"setting": "technique", "values": ["vsn"]}])"), "vsm");
  holds(refusal(R"([{"setting": "scene", "values": ["fense"]}])"), "fence");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1]},
                    {"setting": "kernel.radius", "values": [2]}])"),
        "two axes set");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1], "when": {"technique": "vsm"}}])"),
        "no earlier axis sets 'technique'");
  holds(refusal(R"([{"setting": "technique", "values": ["vsm"]},
                    {"setting": "kernel.radius", "values": [1], "when": {"technique": "vsn"}}])"),
        "to 'vsn'; it takes vsm");
  holds(refusal(R"([{"setting": "technique", "values": ["vsm"]},
                    {"setting": "kernel.radius", "values": [1], "when": {"technique": []}}])"),
        "names no value");
  holds(refusal(R"([{"setting": "technique", "values": ["vsm"]}])",
                R"(, "skip": [{"technique": "esm"}])"),
        "no axis sets 'technique' to 'esm'");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [], "range": [1, 2, 2]}])"),
        "list of values");
  holds(refusal(R"([{"setting": "kernel.radius", "range": [0, 9223372036854775807, 2]}])"),
        "kernel.radius");
  holds(refusal(R"([{"setting": "depth", "values": ["m.exr"]},
                    {"setting": "scene", "values": ["fence"]}])",
                "", R"({"receiver": 0.5})"),
        "of which one can be open");
  holds(refusal(R"([{"zip": [{"setting": "kernel.radius", "values": [1]},
                             {"setting": "map.size", "values": [64, 128]}]}])"),
        "as many values each");
  holds(
      refusal(R"([{"setting": "kernel.radius", "values": [1]}])", R"(, "skip": [{"map.size": 1}])"),
      "no axis sets 'map.size'");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1]}])", R"(, "measures": ["rmse"])"),
        "compare");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1]}])", R"(, "mesures": [])"),
        "measures");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1]}])", R"(, "measures": ["probe"])"),
        "needs a 'probe'");
  holds(refusal(R"([{"setting": "kernel.radius", "values": [1]}])", "",
                R"({"source": {"depth": "m.exr"}})"),
        "needs a 'receiver'");
  holds(refusal(R"([{"setting": "depth", "values": ["n.exr"]}])", "", R"({"receiver": 0.5})"),
        "there is no file");
}

TEST_F(SweepPlans, FilesOfAnAxisAreReadAsTheBaseReadsThem) {
  const SweepPlan swept =
      plan(R"([{"setting": "depth", "values": ["m.exr", "m.exr:Z"]}])", "",
           R"({"source": {"depth": "m.exr", "channel": "D", "range": [0, 2]}, "receiver": 0.5})");
  const TechniqueCatalogue catalogue = allTechniques();
  const auto depthOf = [&](std::size_t cell) {
    return sessionOfCell(swept, cell, catalogue, {}, "plan.json").source.depth;
  };
  EXPECT_EQ(depthOf(0).channel, "D");
  EXPECT_EQ(depthOf(1).channel, "Z");
  EXPECT_EQ(depthOf(1).atOne, 2.0);
}

TEST_F(SweepPlans, ConditionsAndSizesAreWrittenInAnyWay) {
  EXPECT_EQ(cellsOf(plan(R"([{"setting": "bias.receiver-plane", "values": [true, false]},
                             {"setting": "picture.size", "values": [[64, 32], "32x64"],
                              "when": {"bias.receiver-plane": "on"}}])")),
            "bias.receiver-plane=on picture.size=64,32|bias.receiver-plane=on picture.size=32x64|"
            "bias.receiver-plane=off");
}

// Cells that were measured of another content are not those of this plan.
TEST_F(SweepPlans, TheFingerprintIsOfFilesAsWell) {
  const std::string axes = R"([{"setting": "kernel.radius", "values": [1]}])";
  const std::string base = R"({"source": {"depth": "m.exr"}, "receiver": 0.5})";
  const std::string first = plan(axes, "", base).fingerprint;
  EXPECT_EQ(plan(axes, "", base).fingerprint, first);
  EXPECT_NE(plan(R"([{"setting": "kernel.radius", "values": [2]}])", "", base).fingerprint, first);
  std::ofstream(folder_ / "m.exr", std::ios::app) << "x";
  EXPECT_NE(plan(axes, "", base).fingerprint, first);
}

// A buffer beside a glTF file is a part of its shape.
TEST_F(SweepPlans, TheFingerprintIsOfTheBuffersOfGltfAsWell) {
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto writeBuffer = [&](float last) {
    std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners - sizeof last);
    bytes.append(reinterpret_cast<const char*>(&last), sizeof last);
    std::ofstream(folder_ / "m.bin", std::ios::binary) << bytes;
  };
  std::ofstream(folder_ / "m.gltf") << R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"uri": "m.bin", "byteLength": 36}]})";
  const std::string axes = R"([{"setting": "mesh", "values": ["m.gltf"]}])";
  writeBuffer(0.0f);
  const std::string first = plan(axes).fingerprint;
  EXPECT_EQ(plan(axes).fingerprint, first);
  writeBuffer(2.0f);
  EXPECT_NE(plan(axes).fingerprint, first);
}

// Beyond 2^53 doubles skip whole numbers, and beyond 2^63 there is none to convert to.
TEST_F(SweepPlans, ARangeBeyondWholeNumbersIsRefusedByItsSetting) {
  const std::string said =
      refusal(R"([{"setting": "kernel.radius", "range": [0, 9223372036854775807, 2]}])");
  EXPECT_EQ(said.find('-'), std::string::npos) << said;
}

}  // namespace
}  // namespace umbra

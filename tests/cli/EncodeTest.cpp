// Channels as files: names, values, attributes.
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "datasets/maps/DepthFile.h"
#include "datasets/session/file/SchemaCheck.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

class Encode : public testing::Test {
 protected:
  Encode() { writeMap(map, depths); }

  void encode(const Arguments& more) const {
    Arguments arguments{"encode", "--depth", map, "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, out + "\n");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"c.exr", "m.exr"}));
  }

  // The values are as the program wrote them, without scaling: moments lie in [0,1].
  DepthMap channel(const std::string& name) const { return readDepthFile(out, name); }

  const Image<float> depths = smallMap();
  TemporaryFolder folder;
  const std::string map = folder.file("m.exr"), out = folder.file("c.exr");
};

std::set<std::string> channelsOf(const std::string& file) {
  const Imf::InputFile exr(file.c_str());
  std::set<std::string> names;
  const Imf::ChannelList& channels = exr.header().channels();
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    names.insert(it.name());
    EXPECT_EQ(it.channel().type, Imf::FLOAT) << it.name();
  }
  return names;
}

std::string attributeOf(const std::string& file, const std::string& name) {
  const Imf::InputFile exr(file.c_str());
  const auto* value = exr.header().findTypedAttribute<Imf::StringAttribute>(name);
  return value ? value->value() : "absent";
}

TEST_F(Encode, WritesMomentsAfterTheKernel) {
  encode({"--technique", "vsm,power-cdf", "--radius", "1"});
  EXPECT_EQ(channelsOf(out), (std::set<std::string>{"Z", "power-cdf.max", "power-cdf.mean",
                                                    "power-cdf.min", "vsm.M1", "vsm.M2"}));
  const DepthMap z = channel("Z"), m1 = channel("vsm.M1"), m2 = channel("vsm.M2"),
                 low = channel("power-cdf.min"), high = channel("power-cdf.max");
  for (int y = 0; y < depths.height(); ++y)
    for (int x = 0; x < depths.width(); ++x) {
      double mean = 0.0, square = 0.0, min = 1.0, max = 0.0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          const double depth = depths(std::clamp(x + i, 0, depths.width() - 1),
                                      std::clamp(y + j, 0, depths.height() - 1));
          mean += depth / 9;
          square += depth * depth / 9;
          min = std::min(min, depth);
          max = std::max(max, depth);
        }
      EXPECT_EQ(z(x, y), depths(x, y));
      // Stored as float before and after the mean: half a unit in the last place each.
      EXPECT_NEAR(m1(x, y), mean, 1.2e-7);
      EXPECT_NEAR(m2(x, y), square, 1.2e-7);
      EXPECT_EQ(low(x, y), min);
      EXPECT_EQ(high(x, y), max);
    }
}

TEST_F(Encode, WritesWhatEachTexelStoresBeforeTheKernel) {
  encode({"--technique", "vsm", "--stage", "encoded"});
  const DepthMap m1 = channel("vsm.M1"), m2 = channel("vsm.M2");
  for (int y = 0; y < depths.height(); ++y)
    for (int x = 0; x < depths.width(); ++x) {
      EXPECT_EQ(m1(x, y), depths(x, y));
      EXPECT_EQ(m2(x, y), float(double(depths(x, y)) * depths(x, y)));
    }
}

TEST_F(Encode, TheFileExplainsItself) {
  encode({"--technique", "vsm", "--set", "vsm.min-variance=2e-5", "--radius", "5"});
  EXPECT_EQ(attributeOf(out, "umbrascope.version"), UMBRASCOPE_VERSION);
  EXPECT_EQ(attributeOf(out, "vsm.min-variance"), "2e-05");
  EXPECT_EQ(attributeOf(out, "vsm.bleed-reduction"), "0");
  EXPECT_EQ(attributeOf(out, "kernel.radius"), "5");
  EXPECT_EQ(attributeOf(out, "bias.receiver-plane"), "on");
  const auto session = nlohmann::ordered_json::parse(attributeOf(out, "umbrascope.session"));
  const auto schema = nlohmann::ordered_json::parse(run({"settings", "--schema"}).out);
  EXPECT_EQ(schemaFault(schema, session, "session"), "");
}

TEST_F(Encode, ASessionInTheFileMakesTheSameFileAgain) {
  encode({"--technique", "esm", "--kernel", "gaussian", "--radius", "4"});
  const std::string first = contentOf(out);
  const std::string session = folder.file("s.json");
  std::ofstream(session) << attributeOf(out, "umbrascope.session");
  std::filesystem::remove(out);
  EXPECT_EQ(run({"encode", "--session", session, "-o", out}).status, 0);
  EXPECT_EQ(contentOf(out), first);
}

// The file is a session: what it was made of comes back, wherever the program is called from.
TEST_F(Encode, TheFileItselfIsASession) {
  encode({"--technique", "esm", "--kernel", "gaussian", "--radius", "4"});
  const std::string first = contentOf(out), again = folder.file("again.exr");
  EXPECT_EQ(run({"encode", "--session", out, "-o", again}).status, 0);
  EXPECT_EQ(contentOf(again), first);
  const Outcome none = run({"encode", "--session", map, "-o", again});
  EXPECT_EQ(none.status, 3);
  EXPECT_NE(none.err.find("m.exr: holds no session"), std::string::npos) << none.err;
}

TEST_F(Encode, OverwritesWhole) {
  encode({"--technique", "vsm"});
  const std::string first = contentOf(out);
  encode({"--technique", "vsm"});
  EXPECT_EQ(contentOf(out), first);
}

// A map cut out of a larger one keeps its place in what is written of it.
TEST_F(Encode, KeepsTheDataWindowOfTheMap) {
  writeExr(map, {{"Z", depths}}, {}, ExrPixel::Float, {10, -4});
  encode({"--technique", "vsm"});
  const Imf::InputFile exr(out.c_str());
  EXPECT_EQ(exr.header().dataWindow().min, Imath::V2i(10, -4));
  EXPECT_EQ(exr.header().dataWindow().max,
            Imath::V2i(10 + depths.width() - 1, -4 + depths.height() - 1));
  EXPECT_EQ(channel("Z")(3, 5), depths(3, 5));
}

// The engine's file is one that this program wrote, with other settings or by hand.
class EncodeAgainst : public Encode {
 protected:
  Json against(const Arguments& more) const {
    Arguments arguments{"encode", "--depth", map, "--json", "--technique", "vsm"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).json();
  }
  const std::string engine = folder.file("engine.exr");
  // Wide enough that kernels end within it.
  const Image<float> wide = smallMap(150, 140);
};

TEST_F(EncodeAgainst, AgreesWithWhatItWroteItself) {
  for (const char* format : {"float", "half", "unorm16"}) {
    encode({"--technique", "vsm", "--format", format});
    const Json object = against({"--against", out});
    EXPECT_EQ(object["format"], "umbrascope-stored/1");
    EXPECT_EQ(object["against"], "c.exr");
    EXPECT_EQ(object["kernel"], "box");
    ASSERT_EQ(object["channels"].size(), 2u);
    EXPECT_EQ(object["channels"][1]["channel"], "vsm.M2");
    for (const Json& one : object["channels"]) {
      EXPECT_TRUE(one["agrees"]) << one;
      EXPECT_EQ(one["format"], format) << one;
      EXPECT_LT(one["largestUnits"], 4.0);
      EXPECT_TRUE(one["explanation"].is_null());
    }
  }
}

TEST_F(EncodeAgainst, NamesTheKernelThatTheEngineUsed) {
  writeMap(map, wide);
  encode({"--technique", "vsm", "--kernel", "gaussian", "--radius", "4", "--sigma", "1.5"});
  const Json object = against({"--against", out, "--kernel", "box", "--radius", "3"});
  for (const Json& one : object["channels"]) {
    EXPECT_FALSE(one["agrees"]);
    const Json& explanation = one["explanation"];
    EXPECT_EQ(explanation["changes"], 1) << one;
    EXPECT_EQ(explanation["kernel"], "gaussian");
    EXPECT_EQ(explanation["radius"], 4);
    EXPECT_NEAR(explanation["sigma"], 1.5, 1e-4);
    EXPECT_LT(explanation["left"]["largestUnits"], 4.0) << one;
  }
}

// M2 holds the square of the filtered depth, and texels count as the cropped map's own.
TEST_F(EncodeAgainst, ReadsColoursAndNamesASquareThatCameTooLate) {
  writeExr(map, {{"Z", wide}}, {}, ExrPixel::Float, {100, 50});
  encode({"--technique", "vsm", "--radius", "2"});
  const DepthMap m1 = channel("vsm.M1");
  Image<float> red(wide.width(), wide.height()), green = red;
  for (std::size_t i = 0; i < red.values().size(); ++i) {
    red.values()[i] = float(m1.values()[i]);
    green.values()[i] = red.values()[i] * red.values()[i];
  }
  writeExr(engine, {{"R", red}, {"G", green}}, {}, ExrPixel::Float, {100, 50});
  const Json object = against({"--against", engine, "--radius", "2"});
  EXPECT_TRUE(object["channels"][0]["agrees"]);
  EXPECT_EQ(object["channels"][0]["channel"], "R");
  const Json& second = object["channels"][1];
  EXPECT_EQ(second["explanation"]["quantity"], "after-filter") << second;
  EXPECT_GE(second["texel"][0], 100);
  EXPECT_GE(second["texel"][1], 50);
  EXPECT_NE(second["text"].get<std::string>().find("should be filtered"), std::string::npos);
  // A table for people, and the differences as channels.
  const Outcome text = run({"encode", "--depth", map, "--technique", "vsm", "--radius", "2",
                            "--against", engine, "-o", folder.file("d.exr")});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("M2: The filtered depth is encoded"), std::string::npos) << text.out;
  EXPECT_TRUE(channelsOf(folder.file("d.exr")).contains("vsm.M2.difference"));
}

TEST_F(EncodeAgainst, RefusesWhatCannotBeCompared) {
  encode({"--technique", "vsm"});
  const auto refusal = [&](const Arguments& more, int status) {
    Arguments arguments{"encode"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return outcome.err;
  };
  const auto holds = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  holds(refusal({"--depth", map, "--technique", "esm", "--against", out}, 3), "esm.E");
  holds(refusal({"--depth", map, "--technique", "vsm,esm", "--against", out}, 2), "one technique");
  holds(refusal({"--scene", "two-planes", "--against", out}, 2), "--depth");
  holds(refusal({"--depth", map, "--json", "-o", engine}, 2), "--against");
  holds(refusal({"--depth", map, "--technique", "vsm", "--against", out, "--against-channels", "Z"},
                2),
        "names 1, vsm has 2 channels");
  holds(
      refusal({"--depth", map, "--technique", "vsm", "--against", out, "--against-channels", "Z,Y"},
              3),
      "no channel 'Y'");
  writeExr(engine, {{"M1", wide}, {"M2", wide}}, {});
  holds(refusal({"--depth", map, "--technique", "vsm", "--against", engine}, 3),
        "150 × 140 texels, the depth map has 24 × 17");
}

}  // namespace
}  // namespace umbra::cli

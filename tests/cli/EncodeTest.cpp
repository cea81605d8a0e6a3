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

TEST_F(Encode, OverwritesWhole) {
  encode({"--technique", "vsm"});
  const std::string first = contentOf(out);
  encode({"--technique", "vsm"});
  EXPECT_EQ(contentOf(out), first);
}

}  // namespace
}  // namespace umbra::cli

// What `probe` says that the GPU used against what it says that the reference gives, for every
// technique and every way to read the map.
#include <gtest/gtest.h>

#include <set>
#include <variant>

#include "datasets/maps/DepthFile.h"
#include "filters/core/technique/Composition.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "tests/cli/Process.h"
#include "tests/gpu/ProbeBound.h"

namespace umbra::cli {
namespace {

// Near enough to the ground that the first of several cascades has a window of its own. A table's
// sums round in proportion to the map's texels.
const Arguments closeView{"--scene",    "foliage",
                          "--camera",   "0.5,1,4:0,0.5,0",
                          "--size",     "160x120",
                          "--map-size", "64",
                          "--radius",   "2",
                          "--set",      "esm.exponent=10",
                          "--set",      "evsm2.positive-exponent=5"};

struct ReadCase {
  const char* name;
  ReadFilter filter;
  Arguments options;
  bool cascaded = false;
};

std::ostream& operator<<(std::ostream& out, const ReadCase& read) {
  return out << read.name;
}

class ProbeReads : public testing::TestWithParam<ReadCase> {
 protected:
  static Outcome runWith(Arguments arguments, const Arguments& options) {
    for (const Arguments& more : {closeView, options})
      arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  static Json probed(const std::string& pixel) {
    return runWith({"probe", "--json", "--technique", "all", "--pixel", pixel}, GetParam().options)
        .json();
  }

  // The depths of the first cascade's map.
  static DepthMap mapWith(const Arguments& options) {
    const TemporaryFolder folder;
    const Outcome outcome =
        runWith({"encode", "--technique", "hard", "-o", folder.file("map.exr")}, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return readDepthFile(folder.file("map.exr"));
  }

  // The read that the object tells of; it refers to `map`.
  static ProbeRequest requestOf(const Json& object, const FrameSettings& settings,
                                const DepthMap& map) {
    ProbeRequest request{.map = map,
                         .read = {GetParam().filter, object["uv"][0], object["uv"][1]},
                         .kernel = settings.kernel,
                         .format = settings.map.format,
                         .receiver = object["receiver"]};
    if (object.contains("footprint")) {
      const Json& footprint = object["footprint"];
      request.read.footprint = {footprint["x"], footprint["y"], footprint["probes"]};
    }
    return request;
  }
};

TEST_P(ProbeReads, TheGpuUsedWhatTheProbeSays) {
  const DepthMap depths = mapWith(GetParam().options);
  EXPECT_EQ(depths != mapWith({}), GetParam().cascaded) << "a cascade has a window of its own";
  FrameSettings settings;
  settings.map.size = depths.width();
  settings.kernel = {KernelShape::Box, 2};
  settings.read.filter = GetParam().filter;
  const TechniqueCatalogue catalogue = allTechniques();
  std::size_t readable = 0;
  for (const Technique* technique : catalogue.all())
    readable += whyImpossible(settings, *technique).empty();
  // Sums over the map lose digits, of exponentials and four moments most.
  const bool summed = GetParam().filter == ReadFilter::SummedArea;
  int sharp = 0, compared = 0;
  // Techniques that are between lit and dark somewhere; the plain map reads one texel.
  std::set<std::string> telling{"hard"};
  for (const char* pixel : {"83,86", "98,95", "98,86"}) {
    const Json object = probed(pixel);
    ASSERT_EQ(object["cascade"], 0) << pixel << ": the only map that is known here";
    ASSERT_EQ(object["filter"], std::string(nameOf(GetParam().filter)));
    ASSERT_EQ(object["techniques"].size(), readable);
    const double reference = object["reference"];
    for (const Json& row : object["techniques"]) {
      const std::shared_ptr<Technique> technique = catalogue.make(row["name"].get<std::string>());
      for (const Parameter& parameter : technique->parameters())
        if (std::holds_alternative<double>(parameter.get()))
          parameter.put(row["parameters"][std::string(parameter.name)].get<double>());
      technique->limitTo(settings.map.format);
      technique->adapt(depths);
      ProbeRequest request = requestOf(object, settings, depths);
      request.techniques.push_back(technique);
      const Probe probe = takeProbe(request);
      // The read is the one that the program took: the bound is of the right place.
      ASSERT_EQ(probe.techniques.front().visibility, row["visibility"].get<double>()) << row;
      ASSERT_EQ(probe.reference, reference);
      const double bound = test::ProbeBound(*technique, settings, depths)(request, probe);
      EXPECT_NEAR(row["gpu"].get<double>(), row["visibility"].get<double>(), bound)
          << pixel << " " << row["name"];
      ++compared;
      sharp += bound < 0.01;
      const double visibility = row["visibility"];
      if ((bound < 0.01 || summed) && visibility > 0.02 && visibility < 0.98)
        telling.insert(row["name"]);
    }
  }
  for (const Technique* technique : catalogue.all()) {
    const std::string id(technique->info().id);
    EXPECT_TRUE(telling.contains(id) || !whyImpossible(settings, *technique).empty())
        << id << " says lit or dark at every pixel, whatever was read";
  }
  EXPECT_GT(sharp, summed ? compared / 4 : compared * 2 / 3) << "of " << compared;
}

INSTANTIATE_TEST_SUITE_P(
    Every, ProbeReads,
    testing::Values(ReadCase{"point", ReadFilter::Point, {"--filter", "point"}},
                    ReadCase{"bilinear", ReadFilter::Bilinear, {"--filter", "bilinear"}},
                    ReadCase{"trilinear", ReadFilter::Trilinear, {"--filter", "trilinear"}},
                    ReadCase{"anisotropic", ReadFilter::Anisotropic, {"--filter", "anisotropic"}},
                    ReadCase{"sat", ReadFilter::SummedArea, {"--filter", "sat"}},
                    ReadCase{"cascades",
                             ReadFilter::Anisotropic,
                             {"--filter", "anisotropic", "--cascades", "3", "--cascade-seam", "0"},
                             true}),
    [](const auto& read) { return std::string(read.param.name); });

}  // namespace
}  // namespace umbra::cli

// Pairs of technique, filter, format, number of samples and number of cascades. Frames have no
// error and no NaN, visibility stays in [0,1], bounds stay bounds, and a combination that cannot be
// composed is refused with its reason.
#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Pairwise.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

constexpr ReadFilter filters[] = {ReadFilter::Point, ReadFilter::Bilinear, ReadFilter::Trilinear,
                                  ReadFilter::Anisotropic, ReadFilter::SummedArea};
constexpr StorageFormat formats[] = {StorageFormat::Float, StorageFormat::Half,
                                     StorageFormat::Unorm16, StorageFormat::Unorm8};
constexpr KernelShape shapes[] = {KernelShape::Box, KernelShape::Gaussian};
constexpr SatPrecision satPrecisions[] = {SatPrecision::Centred, SatPrecision::Integer,
                                          SatPrecision::Plain};
constexpr int sampleCounts[] = {1, 4}, cascadeCounts[] = {1, 3};

FrameSettings settingsOf(const std::vector<int>& choice) {
  FrameSettings settings;
  settings.map.size = 128;
  settings.kernel.radius = 2;
  settings.read.filter = filters[choice[0]];
  settings.map.format = formats[choice[1]];
  settings.map.samples = sampleCounts[choice[2]];
  settings.map.cascades.count = cascadeCounts[choice[3]];
  settings.kernel.shape = shapes[choice[4]];
  settings.read.satPrecision = satPrecisions[choice[5]];
  return settings;
}

std::string describe(const FrameSettings& s) {
  return std::string(nameOf(s.read.filter)) + " " + std::string(nameOf(s.map.format)) + " " +
         std::to_string(s.map.samples) + " samples " + std::to_string(s.map.cascades.count) +
         " cascades " + umbra::describe(s.kernel) + " " + std::string(nameOf(s.read.satPrecision));
}

class Composition : public test::FrameFixture, public testing::WithParamInterface<std::string> {
 protected:
  void expectSane() {
    const SurfaceImage surfaces = renderer->surfaces();
    const Image<float> reference = renderer->reference();
    for (int y = 0; y < surfaces.height(); ++y) {
      for (int x = 0; x < surfaces.width(); ++x) {
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(surfaces.coded()(x, y, c)));
        ASSERT_GE(surfaces.visibility(x, y), 0.0f) << x << "," << y;
        ASSERT_LE(surfaces.visibility(x, y), 1.0f) << x << "," << y;
        ASSERT_GE(reference(x, y), 0.0f) << x << "," << y;
        ASSERT_LE(reference(x, y), 1.0f) << x << "," << y;
      }
    }
    // Sums over the whole map of values that span many powers of e lose the small ones: the result
    // is then no bound, as the page of such a technique says.
    const bool sumsExactly = settings.read.filter != ReadFilter::SummedArea ||
                             technique->refusal(StorageFormat::Unorm16).empty();
    if (technique->info().upperBound && settings.map.format == StorageFormat::Float && sumsExactly)
      expectBound(surfaces, reference);
  }

  // These are the roundings of a sum over the kernel along both axes, and of mixing two levels
  // bilinearly. A table's entry has twice the logarithm of its size of them, in terms of a sum over
  // the whole map.
  int roundingsOfRead() const {
    const int taps = 2 * settings.kernel.effectiveRadius() + 1, n = settings.map.size;
    if (settings.read.filter != ReadFilter::SummedArea) return 2 * (taps + 2) + 16;
    return int(2 * std::log2(n) * n * n / (taps * taps));
  }

  void expectBound(const SurfaceImage& surfaces, const Image<float>& reference) {
    const test::VisibilityBound bound(*technique, StorageFormat::Float);
    for (int y = 2; y < surfaces.height(); y += 7) {
      for (int x = y % 11; x < surfaces.width(); x += 11) {
        if (surfaces.visibility(x, y) >= reference(x, y)) continue;
        // A bound may be lower only by rounding, in exactly this read.
        const auto point = renderer->surfaceAt(x, y);
        ASSERT_TRUE(point);
        if (point->nextCascade > 0.0) continue;
        const DepthMap& map = renderer->depthMap(point->cascade);
        const ReadPoint read{settings.read.filter, point->u, point->v, point->footprint};
        const Region region = regionOf(map, settings.kernel, read);
        const std::vector<double> channels =
            readChannels(map, *technique, settings.kernel, StorageFormat::Double, read);
        const double tolerance = bound({channels, region}, point->receiver, roundingsOfRead());
        ASSERT_GE(surfaces.visibility(x, y), reference(x, y) - tolerance) << x << "," << y;
      }
    }
  }
};

// The combinations that a table of sums cannot average, written independently of whyImpossible: a
// Gaussian kernel, extremes, and in integers a channel without a range.
bool expectsRefusal(const FrameSettings& s, const Technique& technique) {
  if (!technique.refusal(s.map.format).empty()) return true;
  if (s.read.filter != ReadFilter::SummedArea) return false;
  if (s.kernel.shape == KernelShape::Gaussian) return true;
  if (!technique.info().prefilterable) return false;
  for (const Channel& channel : technique.channels())
    if (channel.reduction != Reduction::Mean) return true;
  return s.read.satPrecision == SatPrecision::Integer &&
         !technique.refusal(StorageFormat::Unorm16).empty();
}

TEST_P(Composition, HoldsInPairs) {
  const std::vector<int> sizes{int(std::size(filters)),      int(std::size(formats)),
                               int(std::size(sampleCounts)), int(std::size(cascadeCounts)),
                               int(std::size(shapes)),       int(std::size(satPrecisions))};
  int drawn = 0;
  show(test::slabAndBall(), GetParam());
  for (const std::vector<int>& choice : test::pairwise(sizes)) {
    settings = settingsOf(choice);
    SCOPED_TRACE(describe(settings));
    const std::string reason = whyImpossible(settings, *technique);
    EXPECT_EQ(!reason.empty(), expectsRefusal(settings, *technique)) << reason;
    if (!reason.empty()) {
      try {
        showAgain();
        FAIL() << "was drawn, though: " << reason;
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      }
      continue;
    }
    showAgain();
    expectSane();
    if (HasFatalFailure()) return;
    ++drawn;
  }
  EXPECT_GT(drawn, 4);
}

std::vector<std::string> ids() {
  std::vector<std::string> ids;
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) ids.emplace_back(technique->info().id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Composition, testing::ValuesIn(ids()),
                         [](const testing::TestParamInfo<std::string>& id) {
                           std::string name = id.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Pairwise, MeetsEveryPair) {
  const std::vector<int> sizes{5, 4, 2, 2, 3};
  const auto combinations = test::pairwise(sizes);
  EXPECT_LT(combinations.size(), 40u);
  for (int a = 0; a < 5; ++a)
    for (int b = a + 1; b < 5; ++b)
      for (int i = 0; i < sizes[a]; ++i)
        for (int j = 0; j < sizes[b]; ++j)
          EXPECT_TRUE(std::any_of(
              combinations.begin(), combinations.end(),
              [&](const std::vector<int>& choice) { return choice[a] == i && choice[b] == j; }))
              << a << ":" << i << " " << b << ":" << j;
}

}  // namespace
}  // namespace umbra

// What a probe computes against what the shaded frame used at its pixel, for every technique and
// every way to read the map.
#include "analysis/frame/FrameReads.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/ProbeBound.h"
#include "tests/properties/Draws.h"

namespace umbra {
namespace {

constexpr ReadFilter everyFilter[] = {ReadFilter::Point, ReadFilter::Bilinear,
                                      ReadFilter::Trilinear, ReadFilter::Anisotropic,
                                      ReadFilter::SummedArea};

class ProbeParity : public test::FrameFixture, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    FrameFixture::SetUp();
    settings.map.size = 64;  // a table's sums round in proportion to its texels
    settings.kernel = {KernelShape::Box, 2};
    settings.read.anisotropy = 4;
  }

  ProbeRequest requestAt(const SurfacePoint& surface) {
    const auto map = [&](int cascade) -> const DepthMap& { return renderer->depthMap(cascade); };
    ProbeRequest request = requestOf(settings, renderer->cascades(), map, surface);
    request.techniques.push_back(probed);
    return request;
  }

  void compareFrame() {
    const test::ProbeBound bound(*probed, settings, renderer->depthMap());
    int compared = 0, sharp = 0, shadowed = 0;
    for (int y = 0; y < height; y += 7) {
      for (int x = 0; x < width; x += 7) {
        const auto surface = renderer->surfaceAt(x, y);
        if (!surface || surface->u < 0 || surface->u > 1 || surface->v < 0 || surface->v > 1)
          continue;
        const ProbeRequest request = requestAt(*surface);
        const Probe probe = takeProbe(request);
        ASSERT_EQ(probe.techniques.size(), 1u);
        const double tolerance = bound(request, probe);
        ASSERT_NEAR(surface->visibility, probe.techniques.front().visibility, tolerance)
            << "pixel " << x << "," << y;
        ++compared;
        sharp += tolerance < 0.01;
        shadowed += probe.reference < 0.9;
      }
    }
    EXPECT_GT(compared, 150);
    EXPECT_GT(shadowed, 10);
    // Receivers at an edge to within rounding say little. Sums over the map lose digits, of four
    // moments most, of what spans many powers of e perhaps all.
    const bool coarse = !whyInexact(settings, *probed).empty();
    const bool summed = settings.read.filter == ReadFilter::SummedArea;
    EXPECT_GT(sharp, coarse ? 0 : summed ? compared / 16 : compared * 2 / 3);
  }

  std::shared_ptr<Technique> probed;
};

TEST_P(ProbeParity, TheFrameUsedWhatTheProbeSays) {
  const auto scene = test::slabAndBall();
  for (ReadFilter filter : everyFilter) {
    SCOPED_TRACE(nameOf(filter));
    settings.read.filter = filter;
    probed = draws::make(GetParam());
    const std::string why = whyImpossible(settings, *probed);
    if (why.empty()) {
      show(scene, GetParam());
      compareFrame();
      if (HasFatalFailure()) return;
      continue;
    }
    // Both refuse, with one reason.
    const DepthMap map(8, 8, 1, 0.5);
    const Probe probe = takeProbe({.map = map,
                                   .read = {filter, 0.5, 0.5, {2.0, 2.0, 1}},
                                   .kernel = settings.kernel,
                                   .techniques = {probed}});
    EXPECT_TRUE(probe.techniques.empty());
    ASSERT_EQ(probe.refused.size(), 1u);
    EXPECT_EQ(probe.refused.front().reason, why);
    try {
      show(scene, GetParam());
      ADD_FAILURE() << "a frame that cannot be was drawn";
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), why);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ProbeParity, testing::ValuesIn(draws::techniqueIds()),
                         [](const auto& drawn) { return draws::caseName(drawn.param); });

}  // namespace
}  // namespace umbra

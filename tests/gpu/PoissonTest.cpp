// Sampled percentage-closer filtering on the GPU against the reference: both must take exactly the
// same texels.
#include "filters/techniques/pcf/Pcf.h"
#include "tests/gpu/ParityFixture.h"

namespace umbra {
namespace {

using namespace test;

class Poisson : public GpuTest {
 protected:
  void TearDown() override {
    baker.reset();
    GpuTest::TearDown();
  }

  // Reads at the centres of all texels, each with a receiver that no depth equals.
  void expectParity(const DepthMap& map, const Kernel& kernel, ReadFilter filter,
                    const Footprint& footprint, int taps) {
    pcf::Pcf technique;
    technique.values = {.taps = pcf::Taps::Poisson, .poissonTaps = taps};
    baker.emplace();
    baker->uploadDepth(map);
    baker->encode(technique, StorageFormat::Float);
    Image<float> reads(map.width(), map.height(), 4), footprints(map.width(), map.height(), 4);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        reads(x, y, 0) = float((x + 0.5) / map.width());
        reads(x, y, 1) = float((y + 0.5) / map.height());
        reads(x, y, 2) = float(0.123 + 0.01 * ((x + 5 * y) % 80));
        footprints(x, y, 0) = float(footprint.x);
        footprints(x, y, 1) = float(footprint.y);
        footprints(x, y, 2) = float(footprint.probes);
      }
    }
    gl::Texture table(GL_RGBA32F, map.width(), map.height()),
        beside(GL_RGBA32F, map.width(), map.height());
    table.upload(4, {reads.values().begin(), reads.values().end()});
    beside.upload(4, {footprints.values().begin(), footprints.values().end()});
    const std::vector<float> gpu = baker->evaluate(table, &beside, technique, {kernel, filter});
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const ReadPoint read{filter, reads(x, y, 0), reads(x, y, 1), footprint};
        const Region region = regionOf(map, kernel, read);
        ASSERT_NEAR(gpu[2 * (std::size_t(y) * map.width() + x)],
                    technique.visibility({{}, region}, reads(x, y, 2)),
                    technique.info().roundings * eps)
            << "texel " << x << "," << y;
      }
    }
  }

  std::optional<ChannelBaker> baker;
};

TEST_F(Poisson, ComparesTheTexelsThatTheReferenceDoes) {
  for (const auto& [name, map] : testMaps()) {
    for (const Kernel& kernel : testKernels()) {
      for (int taps : {4, 16, 64}) {
        SCOPED_TRACE(name + ", " + describe(kernel) + ", " + std::to_string(taps));
        expectParity(map, kernel, ReadFilter::Point, {}, taps);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST_F(Poisson, KeepsToTheKernelsWindowOfALevelledRead) {
  for (const auto& [name, map] : testMaps())
    expectParity(map, {KernelShape::Gaussian, 2}, ReadFilter::Anisotropic, {5.5, -3.25, 3}, 16);
}

}  // namespace
}  // namespace umbra

// Visibility and exact filtering from summed-area tables, for every technique and format that can
// have them, against the reference in double.
#include "filters/core/technique/Composition.h"
#include "tests/gpu/ParityFixture.h"
#include "tests/gpu/SatBound.h"

namespace umbra {
namespace {

using namespace test;

class SatParity : public ParityFixture {
 protected:
  FrameSettings frameOf(SatPrecision precision) const {
    FrameSettings frame;
    frame.map.format = GetParam().format;
    frame.read.filter = ReadFilter::SummedArea;
    frame.read.satPrecision = precision;
    return frame;
  }
};

std::vector<ReadPoint> randomReads(int count) {
  std::mt19937 random(20050902);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<ReadPoint> reads(count);
  for (ReadPoint& read : reads) {
    read.filter = ReadFilter::SummedArea;
    read.u = float(uniform(random));
    read.v = float(uniform(random));
    read.footprint = {float(1.0 + 30.0 * uniform(random)), float(1.0 + 30.0 * uniform(random)), 1};
  }
  return reads;
}

TEST_P(SatParity, BoxesAreReadAsTheReferenceReadsThem) {
  const Kernel kernel{KernelShape::None, 0};
  const std::vector<ReadPoint> points = randomReads(48);
  int sharp = 0, all = 0;  // comparisons to within a hundredth of the whole range
  inEverySetting({kernel}, [&](const DepthMap& map, const Kernel&) {
    prepare(map);
    const VisibilityBound bound(*technique, GetParam().format);
    const Image<double> texels = encoded(map);
    const SatBound sums(*technique, GetParam().format, texels);
    baker->upload(BakeStage::Encoded, toFloat(texels));
    baker->prefilter(kernel);
    for (auto precision : {SatPrecision::Centred, SatPrecision::Integer, SatPrecision::Plain}) {
      if (!whyImpossible(frameOf(precision), *technique).empty()) continue;
      const bool asFloats = technique->info().prefilterable && precision != SatPrecision::Integer;
      if (asFloats && !sums.holds()) continue;
      SCOPED_TRACE(nameOf(precision));
      if (baker->needsSums(precision)) baker->buildSums(precision);
      std::vector<float> surfaces, footprints;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const ReadPoint& point = points[i];
        const Region region = regionOf(map, kernel, point);
        surfaces.insert(surfaces.end(), {float(point.u), float(point.v),
                                         float(receiverFor(int(i), int(i / 5), region)), 0.0f});
        footprints.insert(footprints.end(),
                          {float(point.footprint.x), float(point.footprint.y), 1.0f, 0.0f});
      }
      gl::Texture surfaceTable(GL_RGBA32F, int(points.size()), 1);
      gl::Texture footprintTable(GL_RGBA32F, int(points.size()), 1);
      surfaceTable.upload(4, surfaces);
      footprintTable.upload(4, footprints);
      const std::vector<float> gpu = baker->evaluate(
          surfaceTable, &footprintTable, *technique,
          {.kernel = kernel, .filter = ReadFilter::SummedArea, .satPrecision = precision});
      for (std::size_t i = 0; i < points.size(); ++i) {
        const ReadPoint& point = points[i];
        const double receiver = surfaces[4 * i + 2];
        const Region region = regionOf(map, kernel, point);
        const std::vector<double> channels =
            readChannels(map, *technique, kernel, GetParam().format, point);
        const auto truth = [&](const ReadPoint& at) {
          return referenceVisibility(regionOf(map, kernel, at), receiver);
        };
        // Sums along both axes, each of a product with a difference.
        const double summing = 2 * (32 + 8) * eps;
        const double exact = technique->visibility({channels, region}, receiver);
        const bool prefilterable = technique->info().prefilterable;
        const Fetch fetch{channels, region};
        const double tolerance = prefilterable ? bound(fetch, receiver, 0, sums(precision, point))
                                               : summing + readError(truth, point);
        sharp += tolerance < 0.01;
        ++all;
        ASSERT_NEAR(gpu[2 * i], exact, tolerance)
            << "read " << i << " at " << point.u << "," << point.v << ", box " << point.footprint.x
            << "x" << point.footprint.y << ", receiver " << receiver;
        ASSERT_NEAR(gpu[2 * i + 1], truth(point), summing + readError(truth, point))
            << "reference of read " << i << " at " << point.u << "," << point.v << ", box "
            << point.footprint.x << "x" << point.footprint.y << ", receiver " << receiver;
      }
    }
  });
  // Exponentials and four moments lose most of what sums of floats round.
  EXPECT_GE(sharp, all / 16);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, SatParity, testing::ValuesIn(allCases()), nameOfCase);

}  // namespace
}  // namespace umbra

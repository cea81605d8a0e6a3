// Visibility and exact filtering from summed-area tables, for every technique and format that can
// have them, against the reference in double.
#include "filters/core/technique/Composition.h"
#include "tests/gpu/ParityFixture.h"

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

  // How far one channel's box mean may be off. Sums of floats gather the rounding of the nodes
  // (three times for each of 3 + 3 passes): four nodes and three differences along both axes for
  // each of nine rectangles.
  double sumsError(const Image<double>& encoded, int channel, SatPrecision precision,
                   const ReadPoint& read) const {
    const Footprint& box = read.footprint;
    double low = 1e300, high = -1e300, total = 0.0;
    for (int y = 0; y < encoded.height(); ++y) {
      for (int x = 0; x < encoded.width(); ++x) {
        const double value = encoded(x, y, channel);
        low = std::min(low, value);
        high = std::max(high, value);
        total += std::abs(value);
      }
    }
    const Channel& declared = layout[channel];
    const bool fractions = isNormalised(GetParam().format);
    const double range = declared.high - declared.low;
    // Nine weighted terms of the largest size, and the box's ends, which move the mean.
    const double size = std::max({std::abs(low), std::abs(high), fractions ? range : 0.0});
    const double moved = (61 + 2 * box.x) / box.x + (43 + 2 * box.y) / box.y;
    const double reading = eps * (44 * size + moved * (high - low));
    if (precision == SatPrecision::Integer)
      return reading + (GetParam().format == StorageFormat::Unorm16 ? 0.0 : range * 0.5 / 65535);
    if (fractions) total = 61.0 * 43.0 * range;
    if (precision == SatPrecision::Centred) total = 61.0 * 43.0 * (high - low);
    return reading + (4 * 3 * 6 + 6) * eps * total * largestSatWeight(read.u * 61, box.x, 61) *
                         largestSatWeight(read.v * 43, box.y, 43);
  }

  // How far visibility moves when every channel is off by sumsError.
  double visibilityMoved(const Image<double>& texels, const Fetch& fetch, double receiver,
                         SatPrecision precision, const ReadPoint& read) const {
    const double exact = technique->visibility(fetch, receiver);
    std::vector<double> channels(fetch.channels.begin(), fetch.channels.end());
    double moved = 0.0;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const double value = channels[c], error = sumsError(texels, int(c), precision, read);
      double worst = 0.0;
      for (double shift : {-error, error}) {
        channels[c] = value + shift;
        const double there = technique->visibility({channels, fetch.region}, receiver);
        worst = std::max(worst, std::abs(there - exact));
      }
      channels[c] = value;
      moved += worst;
    }
    return moved;
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
  for (const auto& [name, map] : testMaps()) {
    prepare(map);
    const Image<double> texels = encoded(map);
    baker->upload(BakeStage::Encoded, toFloat(texels));
    baker->prefilter(kernel);
    for (auto precision : {SatPrecision::Centred, SatPrecision::Integer, SatPrecision::Plain}) {
      if (!whyImpossible(frameOf(precision), *technique).empty()) continue;
      SCOPED_TRACE(name + ", " + std::string(nameOf(precision)));
      if (baker->needsSums(precision)) baker->buildSums(precision);
      int sharp = 0;  // the number of comparisons exact to a hundredth of the whole range
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
        const double tolerance =
            prefilterable ? visibilityError(*technique, GetParam().format, fetch, receiver) +
                                visibilityMoved(texels, fetch, receiver, precision, point)
                          : summing + readError(truth, point);
        sharp += tolerance < 0.01;
        ASSERT_NEAR(gpu[2 * i], exact, tolerance)
            << "read " << i << " at " << point.u << "," << point.v << ", box " << point.footprint.x
            << "x" << point.footprint.y << ", receiver " << receiver;
        ASSERT_NEAR(gpu[2 * i + 1], truth(point), summing + readError(truth, point))
            << "reference of read " << i << " at " << point.u << "," << point.v << ", box "
            << point.footprint.x << "x" << point.footprint.y << ", receiver " << receiver;
      }
      // Exponentials and four moments are sensitive to most of the rounding in sums of floats.
      EXPECT_GE(sharp, int(points.size()) / 16);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, SatParity, testing::ValuesIn(allCases()), nameOfCase);

}  // namespace
}  // namespace umbra

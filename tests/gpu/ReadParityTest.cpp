// Mip levels, and trilinear and anisotropic reads of them, against the reference in double.
#include "filters/core/maps/MipLevels.h"
#include "tests/gpu/ParityFixture.h"

namespace umbra {
namespace {

using namespace test;

class ReadParity : public ParityFixture {
 protected:
  // Uploads the map's prefiltered channels of the reference and builds their mip levels.
  void bake(const DepthMap& map, const Kernel& kernel) {
    prepare(map);
    if (!technique->info().prefilterable) return;
    baker->upload(BakeStage::Prefiltered,
                  toFloat(prefilteredMap(map, *technique, kernel, GetParam().format)));
    baker->buildLevels();
  }

  // Level 0 is the prefiltered map.
  std::vector<Image<float>> levels(const DepthMap& map) const {
    std::vector<Image<float>> levels{baker->read(BakeStage::Prefiltered)};
    if (technique->info().prefilterable)
      for (int level = 1; level <= mipLevels(map.width(), map.height()); ++level)
        levels.push_back(baker->readLevel(level));
    return levels;
  }
};

float valueAt(const Image<float>& level, int x, int y, int channel) {
  return level(std::min(x, level.width() - 1), std::min(y, level.height() - 1), channel);
}

// Each level against the one below it as the GPU stored it.
TEST_P(ReadParity, LevelsReduceFourTexelsOfTheLevelBelow) {
  if (!technique->info().prefilterable) return;
  for (const auto& [name, map] : testMaps()) {
    SCOPED_TRACE(name);
    bake(map, {KernelShape::Box, 1});
    const std::vector<Image<float>> all = levels(map);
    ASSERT_EQ(all.size(), 7u) << "64, the power of two above 61, halved down to one";
    for (std::size_t i = 1; i < all.size(); ++i) {
      ASSERT_EQ(all[i].width(), 64 >> i);
      ASSERT_EQ(all[i].height(), 64 >> i);
      for (int y = 0; y < all[i].height(); ++y) {
        for (int x = 0; x < all[i].width(); ++x) {
          for (int c = 0; c < int(layout.size()); ++c) {
            double sum = 0.0, size = 0.0, low = 1e300, high = -1e300;
            for (int corner = 0; corner < 4; ++corner) {
              const double value = valueAt(all[i - 1], 2 * x + corner % 2, 2 * y + corner / 2, c);
              sum += value;
              size += std::abs(value);
              low = std::min(low, value);
              high = std::max(high, value);
            }
            const Reduction reduction = layout[c].reduction;
            const double exact = reduction == Reduction::Mean  ? 0.25 * sum
                                 : reduction == Reduction::Min ? low
                                                               : high;
            // Two sums, one after the other; a quarter is exact. Extremes compute nothing.
            const double tolerance =
                reduction == Reduction::Mean
                    ? storing(exact, layout[c], GetParam().format) + 2 * eps * 0.25 * size
                    : 0.0;
            ASSERT_NEAR(all[i](x, y, c), exact, tolerance)
                << "channel " << c << " of texel " << x << "," << y << " of level " << i;
          }
        }
      }
    }
  }
}

// The extremes of a block of the map, whose edge repeats, equal those of its texels.
TEST_P(ReadParity, ExtremesOfALevelAreThoseOfItsTexels) {
  const DepthMap map = testMaps().back().second;
  bake(map, {KernelShape::Box, 1});
  const std::vector<Image<float>> all = levels(map);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const int side = 1 << i;
    for (int c = 0; c < int(layout.size()); ++c) {
      if (layout[c].reduction == Reduction::Mean) continue;
      for (int y = 0; y < all[i].height(); ++y) {
        for (int x = 0; x < all[i].width(); ++x) {
          float low = valueAt(all[0], x * side, y * side, c), high = low;
          for (int t = 0; t < side * side; ++t) {
            const float value = valueAt(all[0], x * side + t % side, y * side + t / side, c);
            low = std::min(low, value);
            high = std::max(high, value);
          }
          ASSERT_EQ(all[i](x, y, c), layout[c].reduction == Reduction::Min ? low : high)
              << "channel " << c << " of texel " << x << "," << y << " of level " << i;
        }
      }
    }
  }
}

// A read with the reference's weights, of the levels on the GPU.
std::vector<double> mixedLevels(const std::vector<Image<float>>& levels, const ReadPoint& read,
                                int width, int height) {
  std::vector<double> mixed(levels[0].channels(), 0.0);
  for (const LevelRead& at : levelReadsOf(read, width, height)) {
    for (int corner = 0; corner < 4; ++corner) {
      const int right = corner & 1, down = corner >> 1;
      const double weight =
          at.weight * (right ? at.fx : 1.0 - at.fx) * (down ? at.fy : 1.0 - at.fy);
      for (std::size_t c = 0; c < mixed.size(); ++c)
        mixed[c] += weight * valueAt(levels[at.level], at.x[right], at.y[down], int(c));
    }
  }
  return mixed;
}

// Footprints from far below a texel to more than the whole map, in all directions.
std::vector<ReadPoint> randomReads(ReadFilter filter, int count) {
  std::mt19937 random(20111130);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<ReadPoint> reads(count);
  for (ReadPoint& read : reads) {
    const double angle = 6.283 * uniform(random), length = 0.3 * std::pow(300.0, uniform(random));
    read.filter = filter;
    read.u = float(uniform(random));
    read.v = float(uniform(random));
    read.footprint = {float(length * std::cos(angle)), float(length * std::sin(angle)), 1};
    if (filter == ReadFilter::Anisotropic)
      read.footprint.probes = 1 + int(uniform(random) * ReadSettings::largestAnisotropy * 0.999);
  }
  return reads;
}

TEST_P(ReadParity, ReadsMixLevelsAsTheReferenceDoes) {
  const std::vector<Kernel> kernels{{KernelShape::None, 0}, {KernelShape::Gaussian, 3}};
  inEverySetting(kernels, [&](const DepthMap& map, const Kernel& kernel) {
    bake(map, kernel);
    const std::vector<Image<float>> all = levels(map);
    const VisibilityBound bound(*technique, GetParam().format);
    for (ReadFilter filter : {ReadFilter::Trilinear, ReadFilter::Anisotropic}) {
      SCOPED_TRACE(nameOf(filter));
      const std::vector<ReadPoint> reads = randomReads(filter, 48);
      const int count = int(reads.size());
      std::vector<float> surfaces, footprints;
      for (int i = 0; i < count; ++i) {
        const ReadPoint& read = reads[i];
        const Region region = regionOf(map, kernel, read);
        surfaces.insert(surfaces.end(),
                        {float(read.u), float(read.v), float(receiverFor(i, i / 5, region)), 0.0f});
        footprints.insert(footprints.end(), {float(read.footprint.x), float(read.footprint.y),
                                             float(read.footprint.probes), 0.0f});
      }
      gl::Texture surfaceTable(GL_RGBA32F, count, 1), footprintTable(GL_RGBA32F, count, 1);
      surfaceTable.upload(4, surfaces);
      footprintTable.upload(4, footprints);
      const std::vector<float> gpu =
          baker->evaluate(surfaceTable, &footprintTable, *technique, {kernel, filter});
      for (int i = 0; i < count; ++i) {
        const ReadPoint& read = reads[i];
        const double receiver = surfaces[4 * i + 2];
        const auto channelsAt = [&](const ReadPoint& at) {
          return technique->info().prefilterable ? mixedLevels(all, at, map.width(), map.height())
                                                 : std::vector<double>(layout.size(), 0.0);
        };
        const auto visibility = [&](const ReadPoint& at) {
          const Region region = regionOf(map, kernel, at);
          return technique->visibility({channelsAt(at), region}, receiver);
        };
        const auto truth = [&](const ReadPoint& at) {
          return referenceVisibility(regionOf(map, kernel, at), receiver);
        };
        const Region region = regionOf(map, kernel, read);
        const std::vector<double> channels = channelsAt(read);
        // Sums along both axes of every probe's rectangles, and of the probes.
        const int side = 2 * (2 << mipLevels(map.width(), map.height())) + 2 * kernel.radius;
        const double summing = (2 * (side + 8) + 2 * read.footprint.probes) * eps;
        // A mix rounds three times; a read has three for each of two levels and one of these.
        const int mixing = 3 * 4 + read.footprint.probes + 2;
        const double arithmetic = bound({channels, region}, receiver, mixing) +
                                  (technique->info().prefilterable ? 0.0 : summing);
        ASSERT_NEAR(gpu[2 * i], visibility(read), arithmetic + readError(visibility, read))
            << "read " << i << " at " << read.u << "," << read.v << ", footprint "
            << read.footprint.x << "," << read.footprint.y << " with " << read.footprint.probes
            << " probes, receiver " << receiver;
        ASSERT_NEAR(gpu[2 * i + 1], truth(read), summing + readError(truth, read))
            << "reference of read " << i << " at " << read.u << "," << read.v << ", footprint "
            << read.footprint.x << "," << read.footprint.y << " with " << read.footprint.probes
            << " probes, receiver " << receiver;
      }
    }
  });
}

// From depths to a read without help of the reference in between: every store on the way rounds.
// Where both sides differ in a digit or are at a tie, one more unit of the format is allowed.
TEST_P(ReadParity, TheWholeWayEndsWhereTheReferenceDoes) {
  if (!technique->info().prefilterable) return;
  const Kernel kernel{KernelShape::Box, 2};
  const DepthMap map = testMaps().front().second;
  prepare(map);
  baker->upload(BakeStage::Encoded, toFloat(encoded(map)));
  baker->prefilter(kernel);
  baker->buildLevels();
  const std::vector<Image<float>> all = levels(map);
  for (const ReadPoint& read : randomReads(ReadFilter::Trilinear, 24)) {
    const std::vector<double> gpu = mixedLevels(all, read, map.width(), map.height());
    const std::vector<double> cpu = readChannels(map, *technique, kernel, GetParam().format, read);
    const int stores = levelReadsOf(read, map.width(), map.height()).back().level + 1;
    for (std::size_t c = 0; c < layout.size(); ++c) {
      double largest = 0.0;
      for (float value : all[0].values()) largest = std::max(largest, double(std::abs(value)));
      ASSERT_NEAR(gpu[c], cpu[c],
                  2 * stores * storing(largest, layout[c], GetParam().format) +
                      2 * (2 * kernel.radius + 1 + 2) * eps * largest)
          << "channel " << c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ReadParity, testing::ValuesIn(allCases()), nameOfCase);

}  // namespace
}  // namespace umbra

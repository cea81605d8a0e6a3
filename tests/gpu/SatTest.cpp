// Summed-area tables on the GPU against box means in double.
#include <cmath>
#include <random>

#include "filters/gpu/SummedAreaTable.h"
#include "tests/gpu/ParityFixture.h"

namespace umbra {
namespace {

using namespace test;

constexpr SatPrecision precisions[] = {SatPrecision::Centred, SatPrecision::Integer,
                                       SatPrecision::Plain};

// The texels' weights along one axis of `size` as SatRead.glsl should give them, computed for each
// texel by itself and in double.
std::vector<double> coverage(double centre, double width, int size) {
  const double low = centre - width / 2, high = centre + width / 2;
  std::vector<double> weights(size, 0.0);
  for (int i = int(std::floor(low)); i < int(std::ceil(high)); ++i)
    weights[std::clamp(i, 0, size - 1)] +=
        std::max(0.0, std::min(high, i + 1.0) - std::max(low, double(i))) / width;
  return weights;
}

double boxMean(const Image<float>& values, int channel, double x, double y, double width,
               double height) {
  const std::vector<double> across = coverage(x, width, values.width());
  const std::vector<double> down = coverage(y, height, values.height());
  double mean = 0.0;
  for (int j = 0; j < values.height(); ++j) {
    if (down[j] == 0.0) continue;
    for (int i = 0; i < values.width(); ++i) mean += down[j] * across[i] * values(i, j, channel);
  }
  return mean;
}

// The number of float additions, one after the other, by which a node of the table gathers its
// texels: three for each pass over each axis.
int additions(int width, int height) {
  int passes = 0;
  for (int length : {width, height})
    for (int step = 1; step < length; step *= 4) ++passes;
  return 3 * passes;
}

// A technique whose visibility is the channel that the receiver names, so that a test can see what
// a read gives.
class Channels final : public TechniqueWith<Channels, NoParameters> {
 public:
  const TechniqueInfo& info() const override {
    static const TechniqueInfo info{"channels", "Channels", "", "", ""};
    return info;
  }
  std::vector<Channel> channels() const override {
    return {{"z"}, {"1-z"}, {"z/2"}, {"1-z/2"}, {"z-1", Reduction::Mean, -1.0, 0.0}};
  }
  void encode(double z, std::span<double> channels) const override {
    const double encoded[] = {z, 1 - z, z / 2, 1 - z / 2, z - 1};
    std::copy(std::begin(encoded), std::end(encoded), channels.begin());
  }
  double visibility(const Fetch& fetch, double receiver) const override {
    return fetch.channels[std::size_t(receiver)];
  }
  Trace explain(const Fetch&, double) const override { return {}; }
  std::string_view glsl() const override {
    return R"(
void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
  channels[1] = 1.0 - z;
  channels[2] = 0.5 * z;
  channels[3] = 1.0 - 0.5 * z;
  channels[4] = z - 1.0;
}
float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  return channels[int(receiver)];
}
)";
  }
  std::string_view page() const override { return {}; }
};

struct Box {
  double u, v;  // floats
  double width, height;
  int channel = 0, cascade = 0;
};

std::vector<Box> randomBoxes(int count) {
  std::mt19937 random(20050901);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    box = {float(uniform(random)), float(uniform(random)), float(std::pow(255.0, uniform(random))),
           float(std::pow(255.0, uniform(random)))};
    box.channel = int(uniform(random) * 4.999);
  }
  // Corners, whole texels, the whole map and the largest box of all.
  boxes.insert(boxes.end(), {{0, 0, 1, 1}, {1, 1, 1, 1}, {0.5, 0.5, 61, 43}, {1, 0, 255, 255, 4}});
  return boxes;
}

class Sat : public GpuTest {
 protected:
  void TearDown() override {
    baker.reset();
    GpuTest::TearDown();
  }

  void bake(const std::vector<DepthMap>& maps, SatPrecision precision, StorageFormat format) {
    if (!baker) baker.emplace();
    baker->prepareDepth(maps[0].width(), maps[0].height(), int(maps.size()));
    for (std::size_t i = 0; i < maps.size(); ++i) baker->uploadDepth(maps[i], int(i));
    baker->encode(technique, format);
    baker->prefilter({KernelShape::None, 0});
    baker->buildSums(precision);
  }

  std::vector<float> means(const std::vector<Box>& boxes, SatPrecision precision) {
    return evaluate(boxes, ReadFilter::SummedArea, {}, precision);
  }

  std::vector<float> evaluate(const std::vector<Box>& boxes, ReadFilter filter,
                              const Kernel& kernel,
                              SatPrecision precision = SatPrecision::Centred) {
    std::vector<float> surfaces, footprints;
    for (const Box& box : boxes) {
      surfaces.insert(surfaces.end(), {float(box.u), float(box.v), float(box.channel), 0.0f});
      footprints.insert(footprints.end(),
                        {float(box.width), float(box.height), 1.0f, float(box.cascade)});
    }
    gl::Texture surfaceTable(GL_RGBA32F, int(boxes.size()), 1);
    gl::Texture footprintTable(GL_RGBA32F, int(boxes.size()), 1);
    surfaceTable.upload(4, surfaces);
    footprintTable.upload(4, footprints);
    const std::vector<float> both =
        baker->evaluate(surfaceTable, &footprintTable, technique,
                        {.kernel = kernel, .filter = filter, .satPrecision = precision});
    std::vector<float> result;
    for (std::size_t i = 0; i < boxes.size(); ++i) result.push_back(both[2 * i]);
    return result;
  }

  Channels technique;
  std::optional<ChannelBaker> baker;
};

// How far a float table's mean may be off where the absolute values that it sums add up to `total`.
// Every node has rounded each of its additions; a rectangle takes four nodes and three differences,
// and is weighted along both axes.
double sumsError(double total, const DepthMap& map, const Box& box) {
  return (4 * additions(map.width(), map.height()) + 3 * 2) * eps * total *
         largestSatWeight(box.u * map.width(), box.width, map.width()) *
         largestSatWeight(box.v * map.height(), box.height, map.height());
}

// Positions are rounded as products with the map's size, the box's ends as sums of up to the box's
// width; a mean of values over a range of 1 moves by 1 / width of that. Nine weighted terms, each
// with a product, a division and a sum.
double readingError(const Box& box, const DepthMap& map) {
  const double across = (map.width() + 2 * box.width) / box.width;
  const double down = (map.height() + 2 * box.height) / box.height;
  return eps * (across + down + 9 * 4 + 8);
}

TEST_F(Sat, BoxMeansAgreeWithTheReferenceInEveryPrecision) {
  const auto maps = testMaps();
  for (StorageFormat format : {StorageFormat::Float, StorageFormat::Half, StorageFormat::Unorm16}) {
    for (SatPrecision precision : precisions) {
      SCOPED_TRACE(std::string(nameOf(format)) + ", " + std::string(nameOf(precision)));
      bake({maps[0].second, maps[2].second}, precision, format);
      std::vector<Box> boxes = randomBoxes(60);
      for (std::size_t i = 0; i < boxes.size(); i += 2) boxes[i].cascade = 1;
      const std::vector<float> gpu = means(boxes, precision);
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = boxes[i];
        const DepthMap& map = maps[box.cascade == 0 ? 0 : 2].second;
        const Image<float> stored = baker->read(BakeStage::Encoded, box.cascade);
        const double exact = boxMean(stored, box.channel, box.u * map.width(), box.v * map.height(),
                                     box.width, box.height);
        // All values lie within a range of 1, about 0 or about the value that is subtracted.
        const double total = double(map.width()) * map.height();
        const double summing = precision == SatPrecision::Integer
                                   ? (format == StorageFormat::Unorm16 ? 0.0 : 0.5 / 65535)
                                   : sumsError(total, map, box);
        ASSERT_NEAR(gpu[i], exact, summing + readingError(box, map))
            << "box " << i << " at " << box.u << "," << box.v << ", " << box.width << "x"
            << box.height << ", channel " << box.channel;
      }
    }
  }
}

constexpr int large = 1024;

// The values are far from zero and near each other.
DepthMap largeMap() {
  std::mt19937 random(20081015);
  std::uniform_real_distribution<double> uniform(0.9, 0.9125);
  DepthMap map(large, large);
  for (double& z : map.values()) z = float(uniform(random));
  return map;
}

// Boxes of one texel each, at the corner where the sums are largest.
std::vector<Box> farTexels() {
  std::vector<Box> boxes;
  for (int i = 0; i < 64; ++i)
    boxes.push_back({(large - 1 - i + 0.5) / large, (large - 1 - i * 7 % 64 + 0.5) / large, 1, 1});
  return boxes;
}

TEST_F(Sat, PlainSumsLoseDigitsThatCentredOnesKeep) {
  const DepthMap map = largeMap();
  const std::vector<Box> boxes = farTexels();
  double smallestPlain = 1.0, largestCentred = 0.0;
  for (SatPrecision precision : {SatPrecision::Plain, SatPrecision::Centred}) {
    bake({map}, precision, StorageFormat::Float);
    const std::vector<float> gpu = means(boxes, precision);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double exact = map(int(boxes[i].u * large), int(boxes[i].v * large));
      const double error = std::abs(gpu[i] - exact);
      if (precision == SatPrecision::Plain) smallestPlain = std::min(smallestPlain, error);
      if (precision == SatPrecision::Centred) largestCentred = std::max(largestCentred, error);
    }
  }
  // Floats from 2^19 on are multiples of 1/16, and so are their differences: the nearest to these
  // values are 0.875 and 0.9375.
  EXPECT_GE(smallestPlain, 0.9 - 0.875 - 1e-6);
  EXPECT_LT(largestCentred, smallestPlain / 100);
}

TEST_F(Sat, IntegersRunOverAndAreExactAllTheSame) {
  const DepthMap map = largeMap();  // sums up to 6e10, fourteen times 2^32
  const std::vector<Box> boxes = farTexels();
  bake({map}, SatPrecision::Integer, StorageFormat::Float);
  const std::vector<float> gpu = means(boxes, SatPrecision::Integer);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    EXPECT_NEAR(gpu[i], map(int(boxes[i].u * large), int(boxes[i].v * large)),
                0.5 / 65535 + readingError(boxes[i], map));
  // The largest box of the largest value must be exact, without any rounding.
  bake({DepthMap(large, large, 1, 1.0)}, SatPrecision::Integer, StorageFormat::Float);
  const Box box{0.5, 0.5, ReadSettings::largestSatWidth, ReadSettings::largestSatWidth};
  EXPECT_NEAR(means({box}, SatPrecision::Integer)[0], 1.0, 16 * eps);
}

// Between the outermost texels' centres: beyond, a bilinear read repeats blurred texels.
TEST_F(Sat, AFixedBoxIsABilinearReadOfTheBoxBlur) {
  const DepthMap map = testMaps().back().second;
  std::vector<Box> boxes;
  for (const Box& box : randomBoxes(40))
    boxes.push_back({float((0.5 + box.u * (map.width() - 1)) / map.width()),
                     float((0.5 + box.v * (map.height() - 1)) / map.height()), 7, 7, box.channel});
  const Kernel kernel{KernelShape::Box, 3};
  for (SatPrecision precision : precisions) {
    SCOPED_TRACE(std::string(nameOf(precision)));
    bake({map}, precision, StorageFormat::Float);
    const std::vector<float> summed = means(boxes, precision);
    baker->prefilter(kernel);
    const std::vector<float> blurred = evaluate(boxes, ReadFilter::Bilinear, kernel);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double total = double(map.width()) * map.height();
      const double summing =
          precision == SatPrecision::Integer ? 0.5 / 65535 : sumsError(total, map, boxes[i]);
      // A blur of two axes of seven terms, and its bilinear mix.
      EXPECT_NEAR(summed[i], blurred[i],
                  summing + 2 * readingError(boxes[i], map) + (2 * 9 + 9) * eps)
          << "box " << i;
    }
  }
}

}  // namespace
}  // namespace umbra

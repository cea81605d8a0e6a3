// What an engine may do otherwise is done to channels, and must be found.
#include "analysis/stored/StoredCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

constexpr Kernel box3{KernelShape::Box, 1, 0.0}, box7{KernelShape::Box, 3, 0.0};

// Slopes and steps, so that no two of the things tried give the same values.
DepthMap scenery(int side = 160) {
  DepthMap map(side, side);
  std::mt19937 random(5);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map(x, y) = ((x / 7 + y / 11) % 3 == 0 ? 0.2 : 0.7) + 0.001 * x + 0.0005 * y * y / side +
                  0.02 * double(random() % 1000) / 1000.0;
  return map;
}

class Stored : public testing::TestWithParam<const char*> {
 protected:
  StoredFinding check(const Image<double>& stored, int channel = 0, const Kernel& kernel = box7,
                      StorageFormat format = StorageFormat::Double) const {
    return checkStored({map_, *technique_, channel, kernel, format}, stored, [] {});
  }
  Image<double> channel(int index, const Kernel& kernel,
                        StorageFormat format = StorageFormat::Double) const {
    const Image<double> all = prefilteredMap(map_, *technique_, kernel, format);
    Image<double> one(all.width(), all.height());
    for (int y = 0; y < one.height(); ++y)
      for (int x = 0; x < one.width(); ++x) one(x, y) = all(x, y, index);
    return one;
  }

  const DepthMap map_ = scenery();
  const std::unique_ptr<Technique> technique_ = allTechniques().make(GetParam());
  const int last_ = int(technique_->channels().size()) - 1;
};

TEST_P(Stored, AgreesWithItself) {
  for (const StorageFormat format :
       {StorageFormat::Double, StorageFormat::Float, StorageFormat::Half, StorageFormat::Unorm16}) {
    // Exponentials leave the range of all formats but these two.
    if (GetParam() == std::string("esm") && format < StorageFormat::Float) continue;
    const StoredFinding finding = check(channel(last_, box7, format), last_, box7, format);
    EXPECT_TRUE(finding.agrees) << finding.text;
    EXPECT_FALSE(finding.explanation);
  }
}

TEST_P(Stored, TellsAnotherKernel) {
  const StoredFinding other = check(channel(last_, box3), last_);
  ASSERT_TRUE(other.explanation) << other.text;
  EXPECT_EQ(other.explanation->assumption.kernel, box3) << other.text;
  EXPECT_EQ(other.explanation->changes, 1);
  EXPECT_TRUE(other.explanation->isWhole);
  EXPECT_FALSE(other.agrees);
  const StoredFinding none = check(channel(last_, {KernelShape::None, 0, 0.0}), last_);
  EXPECT_NE(none.text.find("not filtered"), std::string::npos) << none.text;
}

TEST_P(Stored, TellsAShift) {
  StoredAssumption shifted;
  shifted.kernel = box7;
  shifted.shiftX = 0.5;
  shifted.shiftY = -1.0;
  const StoredQuestion question{map_, *technique_, last_, box7, StorageFormat::Double};
  const StoredFinding finding = check(expectedUnder(shifted, question).values, last_);
  ASSERT_TRUE(finding.explanation) << finding.text;
  EXPECT_EQ(finding.explanation->assumption.shiftX, 0.5) << finding.text;
  EXPECT_EQ(finding.explanation->assumption.shiftY, -1.0) << finding.text;
  EXPECT_EQ(finding.explanation->changes, 1);
}

TEST_P(Stored, TellsRowsFromBelowAndAScale) {
  StoredAssumption below;
  below.kernel = box7;
  below.rowsFromBelow = true;
  const StoredQuestion question{map_, *technique_, last_, box7, StorageFormat::Double};
  const StoredFinding turnedRound = check(expectedUnder(below, question).values, last_);
  ASSERT_TRUE(turnedRound.explanation) << turnedRound.text;
  EXPECT_TRUE(turnedRound.explanation->assumption.rowsFromBelow) << turnedRound.text;
  EXPECT_EQ(turnedRound.explanation->changes, 1);
  StoredAssumption scaled;
  scaled.kernel = box7;
  scaled.scale = 2.0;
  const Image<double> own = channel(last_, box7);
  scaled.offset = -*std::max_element(own.values().begin(), own.values().end());
  const StoredFinding stretched = check(expectedUnder(scaled, question).values, last_);
  ASSERT_TRUE(stretched.explanation) << stretched.text;
  EXPECT_NEAR(stretched.explanation->assumption.scale, 2.0, 1e-6) << stretched.text;
  EXPECT_NEAR(stretched.explanation->assumption.offset / scaled.offset, 1.0, 1e-6)
      << stretched.text;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Stored, testing::Values("vsm", "esm", "msm", "power-cdf"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::erase(name, '-');
                           return name;
                         });

using StoredMoments = Stored;
INSTANTIATE_TEST_SUITE_P(Vsm, StoredMoments, testing::Values("vsm"));

TEST_P(StoredMoments, TellDepthsInPlaceOfTheirSquares) {
  const StoredFinding depth = check(channel(0, box7), 1);
  ASSERT_TRUE(depth.explanation) << depth.text;
  EXPECT_EQ(depth.explanation->assumption.quantity, StoredQuantity::Depth) << depth.text;
  Image<double> squared = channel(0, box7);
  for (double& value : squared.values()) value *= value;
  const StoredFinding late = check(squared, 1);
  ASSERT_TRUE(late.explanation) << late.text;
  EXPECT_EQ(late.explanation->assumption.quantity, StoredQuantity::AfterFilter) << late.text;
}

TEST_P(StoredMoments, TellTheSigmaOfAGaussian) {
  const Kernel narrow{KernelShape::Gaussian, 4, 1.37};
  const StoredFinding finding =
      check(channel(1, narrow), 1, {KernelShape::Gaussian, 4, 0.0}, StorageFormat::Float);
  ASSERT_TRUE(finding.explanation) << finding.text;
  EXPECT_EQ(finding.explanation->assumption.kernel.radius, 4) << finding.text;
  EXPECT_NEAR(finding.explanation->assumption.kernel.sigma, 1.37, 1e-4) << finding.text;
}

TEST_P(StoredMoments, TellTheFormatThatHoldsTheValues) {
  const StoredFinding half =
      check(channel(1, box7, StorageFormat::Half), 1, box7, StorageFormat::Float);
  EXPECT_EQ(half.heldBy, StorageFormat::Half);
  EXPECT_TRUE(half.agrees);
  EXPECT_GT(half.difference.largestUnits, 100.0);  // of float
  EXPECT_NE(half.text.find("numbers of half"), std::string::npos) << half.text;
}

// Zeros beyond the map's edge, as a texture's border has them.
TEST_P(StoredMoments, TellEdgesThatAreTreatedOtherwise) {
  Image<double> stored = channel(0, box7);
  for (int x = 0; x < stored.width(); ++x) stored(x, 1) *= 0.7;
  const StoredFinding finding = check(stored, 0);
  EXPECT_TRUE(finding.onlyAtEdges) << finding.text;
  EXPECT_EQ(finding.difference.y, 1);
}

TEST_P(StoredMoments, SayWhatNothingExplains) {
  Image<double> noise(map_.width(), map_.height());
  std::mt19937 random(9);
  for (double& value : noise.values()) value = double(random() % 1000) / 1000.0;
  const StoredFinding finding = check(noise, 0);
  EXPECT_FALSE(finding.explanation);
  EXPECT_NE(finding.text.find("No kernel"), std::string::npos) << finding.text;
  noise(3, 4) = NAN;
  EXPECT_NE(check(noise, 0).text.find("1 texel holds no number"), std::string::npos);
}

// Huge exact values are far from any others, near which everything small then lies.
TEST(StoredExponentials, AreExplainedByNothingSmall) {
  const DepthMap map = scenery();
  const std::unique_ptr<Technique> esm = allTechniques().make("esm");
  const StoredQuestion question{map, *esm, 0, box7, StorageFormat::Float};
  std::mt19937 random(2);
  Image<double> small(map.width(), map.height());
  for (double& value : small.values()) value = double(random() % 1000) / 1000.0;
  EXPECT_FALSE(checkStored(question, small, [] {}).explanation);
  for (double& value : small.values()) value = 0.5;
  const StoredFinding constant = checkStored(question, small, [] {});
  EXPECT_FALSE(constant.explanation);
  EXPECT_NE(constant.text.find("All values are 0.5"), std::string::npos) << constant.text;
}

// Values of 8 bits in floats do not make an error of one of their steps a rounding.
TEST(StoredSteps, AreNotTakenForRounding) {
  DepthMap map(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) map(x, y) = float((40 + x + y) / 255.0f);
  const std::unique_ptr<Technique> vsm = allTechniques().make("vsm");
  const Kernel none{KernelShape::None, 0, 0.0};
  Image<double> off(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) off(x, y) = float((41 + x + y) / 255.0f);
  const StoredFinding finding = checkStored({map, *vsm, 0, none, StorageFormat::Float}, off, [] {});
  EXPECT_EQ(finding.heldBy, StorageFormat::Unorm8);
  EXPECT_FALSE(finding.agrees) << finding.text;
}

TEST(LastPlaces, AreTheDistancesOfNeighbours) {
  const Channel unit, wide{"S", Reduction::Mean, -1.0, 1.0};
  EXPECT_EQ(lastPlaceOf(StorageFormat::Half, 1.0, unit), 0x1p-10);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Half, 0.99, unit), 0x1p-11);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Half, 0.0, unit), 0x1p-24);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Float, -3.0, unit), 0x1p-22);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Float, 0.0, unit), 0x1p-149);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Double, 1.0, unit), 0x1p-52);
  EXPECT_EQ(lastPlaceOf(StorageFormat::Unorm8, 0.3, wide), 2.0 / 255.0);
}

}  // namespace
}  // namespace umbra

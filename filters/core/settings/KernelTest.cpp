#include "filters/core/settings/Kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace umbra {
namespace {

TEST(Kernel, WeightsAreSymmetricAndSumToOne) {
  for (KernelShape shape : {KernelShape::None, KernelShape::Box, KernelShape::Gaussian}) {
    for (int radius : {0, 1, 2, 7, Kernel::largestRadius}) {
      const Kernel kernel{shape, radius};
      const std::vector<double> weights = kernel.weights();
      ASSERT_EQ(int(weights.size()), 2 * kernel.effectiveRadius() + 1);
      for (std::size_t i = 0; i < weights.size(); ++i)
        EXPECT_EQ(weights[i], weights[weights.size() - 1 - i]);
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0,
                  double(weights.size()) * 2.3e-16);
    }
  }
}

TEST(Kernel, NoneHasOneTapWhateverItsRadius) {
  EXPECT_EQ((Kernel{KernelShape::None, 9}.weights()), std::vector<double>{1.0});
  EXPECT_EQ((Kernel{KernelShape::None, 9}.effectiveRadius()), 0);
}

TEST(Kernel, BoxWeighsAllAlike) {
  for (double weight : Kernel{KernelShape::Box, 3}.weights()) EXPECT_EQ(weight, 1.0 / 7.0);
}

TEST(Kernel, GaussianFallsAsItsSigmaSays) {
  // Sigma is half the radius unless it is set.
  for (const auto& [kernel, sigma] : {std::pair(Kernel{KernelShape::Gaussian, 4}, 2.0),
                                      std::pair(Kernel{KernelShape::Gaussian, 4, 0.8}, 0.8)}) {
    const std::vector<double> weights = kernel.weights();
    for (int i = 1; i <= 4; ++i)
      EXPECT_NEAR(weights[4 + i] / weights[4], std::exp(-i * i / (2 * sigma * sigma)), 1e-15);
  }
}

TEST(Kernel, GaussianIsSoundAtEitherEndOfItsSigmas) {
  for (double sigma : {Kernel::smallestSigma, Kernel::largestSigma}) {
    const Kernel kernel{KernelShape::Gaussian, Kernel::largestRadius, sigma};
    double sum = 0.0;
    for (double weight : kernel.weights()) {
      EXPECT_TRUE(weight >= 0.0 && weight <= 1.0) << sigma;
      sum += weight;
    }
    EXPECT_NEAR(sum, 1.0, 129 * 0x1p-53);  // rounding of 129 weights
  }
}

TEST(Kernel, DescribesItself) {
  EXPECT_EQ(describe({KernelShape::Box, 3}), "box 7×7");
  EXPECT_EQ(describe({KernelShape::Gaussian, 3}), "Gaussian 7×7, σ 1.5");
  EXPECT_EQ(describe({KernelShape::None, 3}), "no prefilter");
}

}  // namespace
}  // namespace umbra

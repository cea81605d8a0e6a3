#include "analysis/frame/FrameReads.h"

#include <gtest/gtest.h>

#include "analysis/errors/FrameDecomposition.h"
#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

constexpr int evenWidth = 40, evenHeight = 24;

// A frame whose pixels read a map evenly, at one depth; every fifth column is turned away from the
// light.
struct EvenFrame {
  explicit EvenFrame(const char* id, double reduction = 0.0) {
    const std::unique_ptr<Technique> made = allTechniques().make(id);
    if (reduction > 0.0)
      parameterNamed(made->parameters(), "bleed-reduction", id).set(reduction, id);
    technique = made->clone();
    drawn.settings.kernel = {KernelShape::Box, 2};
    drawn.settings.read.filter = ReadFilter::Bilinear;
    drawn.settings.map.format = StorageFormat::Half;
    drawn.maps = {map};
    drawn.cascades.resize(1);
    drawn.surfaces = SurfaceImage(evenWidth, evenHeight);
    reference = Image<float>(evenWidth, evenHeight);
    for (int y = 0; y < evenHeight; ++y)
      for (int x = 0; x < evenWidth; ++x) {
        SurfacePoint surface{
            .u = float(x) / evenWidth, .v = float(y) / evenHeight, .receiver = 0.62F};
        surface.facesLight = x % 5 != 0;
        drawn.surfaces.set(x, y, surface);
        ProbeRequest request = requestAt(drawn, x, y);
        request.techniques = {technique};
        const Probe probe = takeProbe(request);
        surface.visibility = probe.techniques[0].visibility;
        drawn.surfaces.set(x, y, surface);
        reference(x, y) = float(probe.reference);
      }
  }
  ErrorDecomposition taken(int stride = 1) const {
    return decomposeFrame(drawn, reference, technique, {}, stride, [](double) {});
  }

  std::shared_ptr<const DepthMap> map = std::make_shared<const DepthMap>(randomMap(32, 32, 5));
  std::shared_ptr<const DepthMap> next = std::make_shared<const DepthMap>(randomMap(32, 32, 6));
  FrameSnapshot drawn;
  Image<float> reference;
  std::shared_ptr<const Technique> technique;
};

TEST(FrameReads, APixelReadsWhatTheSettingsSay) {
  const EvenFrame frame("vsm");
  const ProbeRequest request = requestAt(frame.drawn, 7, 9);
  EXPECT_EQ(&request.map, frame.map.get());
  EXPECT_EQ(request.read.filter, ReadFilter::Bilinear);
  EXPECT_EQ(request.read.u, double(7.0F / evenWidth));
  EXPECT_EQ(request.read.v, double(9.0F / evenHeight));
  EXPECT_EQ(request.kernel, frame.drawn.settings.kernel);
  EXPECT_EQ(request.format, StorageFormat::Half);
  EXPECT_EQ(request.receiver, double(0.62F));
  EXPECT_EQ(requestAt(frame.drawn, 5, 9).receiver, double(0.62F)) << "turned away";
  EXPECT_EQ(request.cascade, 0);
  EXPECT_FALSE(request.seam);
}

TEST(FrameReads, FootprintsAndCascadesAreThePixelsOwn) {
  EvenFrame frame("vsm");
  frame.drawn.settings.read.filter = ReadFilter::Anisotropic;
  frame.drawn.maps = {frame.map, frame.next};
  frame.drawn.cascades.resize(2);
  frame.drawn.cascades[1].side = 0.5;
  frame.drawn.surfaces = SurfaceImage(evenWidth, evenHeight, true);
  SurfacePoint inSeam{.u = 0.1, .v = 0.2, .receiver = 0.62}, inNext = inSeam;
  inSeam.footprint = {6.0, 2.0, 3};
  inSeam.nextCascade = 0.25;
  inNext.footprint = {4.0, 1.0, 2};
  inNext.cascade = 1;
  frame.drawn.surfaces.set(3, 4, inSeam);
  frame.drawn.surfaces.set(4, 4, inNext);
  const ProbeRequest seam = requestAt(frame.drawn, 3, 4);
  EXPECT_EQ(seam.read.footprint, (Footprint{6.0, 2.0, 3}));
  EXPECT_EQ(&seam.map, frame.map.get());
  ASSERT_TRUE(seam.seam);
  EXPECT_EQ(seam.seam->weight, 0.25);
  EXPECT_EQ(&seam.seam->map, frame.next.get());
  // Texels of a window half as wide are half as large.
  EXPECT_EQ(seam.seam->read.footprint, (Footprint{12.0, 4.0, 3}));
  const ProbeRequest next = requestAt(frame.drawn, 4, 4);
  EXPECT_EQ(&next.map, frame.next.get());
  EXPECT_EQ(next.cascade, 1);
  EXPECT_FALSE(next.seam);
}

TEST(FrameReads, TapsAreCountedOnAGrid) {
  const EvenFrame frame("vsm");
  // Pixels (0 | 16 | 32, 0 | 16) read positions half-way between texels or nearer to one: at
  // u = 0, v = 0 the taps left of the map repeat its edge and count as well.
  double expected = 0.0;
  for (int y : {0, 16})
    for (int x : {0, 16, 32})
      expected += double(takeProbe(requestAt(frame.drawn, x, y)).region.texels.size());
  EXPECT_EQ(tapsOf(frame.drawn, [](int, int) { return true; }), 256.0 * expected);
  EXPECT_EQ(tapsOf(frame.drawn, [](int x, int) { return x > 32; }), 0.0);
}

TEST(FrameReads, AGridReadsNoMoreThanIsAllowed) {
  EXPECT_EQ(strideFor(0.0, 10.0), 1);
  EXPECT_EQ(strideFor(10.0, 10.0), 1);
  EXPECT_EQ(strideFor(11.0, 10.0), 2);
  EXPECT_EQ(strideFor(40.0, 10.0), 2);
  EXPECT_EQ(strideFor(41.0, 10.0), 3);
}

TEST(FrameDecomposition, TakesEveryPixelAsOneTakesIt) {
  const EvenFrame frame("vsm", 0.2);
  const ErrorDecomposition taken = frame.taken();
  const auto techniques = decompositionTechniques(frame.technique);
  for (int y = 0; y < evenHeight; ++y)
    for (int x = 0; x < evenWidth; ++x) {
      ASSERT_EQ(taken.receives(x, y), x % 5 == 0 ? 0 : 1);
      if (!taken.receives(x, y)) continue;
      const double v = frame.drawn.surfaces.visibility(x, y), truth = frame.reference(x, y);
      if (!worthDecomposing(v, truth, true, {})) continue;
      ProbeRequest request = requestAt(frame.drawn, x, y);
      request.format = StorageFormat::Double;
      request.techniques = techniques;
      const ErrorParts expected = decomposed(v, truth, takeProbe(request));
      for (int i = 0; i < errorPartCount; ++i)
        ASSERT_EQ(taken.parts(x, y, i), expected[i]) << x << "," << y << " " << i;
    }
}

TEST(FrameDecomposition, AGridHasTheSamePixelsOrNone) {
  const EvenFrame frame("vsm");
  const ErrorDecomposition every = frame.taken(), third = frame.taken(3);
  EXPECT_EQ(third.stride, 3);
  std::size_t pixels = 0;
  for (int y = 0; y < evenHeight; ++y)
    for (int x = 0; x < evenWidth; ++x) {
      const bool onGrid = x % 3 == 0 && y % 3 == 0;
      EXPECT_EQ(third.receives(x, y), onGrid ? every.receives(x, y) : 0);
      pixels += onGrid && every.receives(x, y);
      const PicturePixel stands = third.takenPixel(x, y);
      EXPECT_TRUE(stands.x % 3 == 0 && stands.y % 3 == 0 && x - stands.x < 3 && y - stands.y < 3);
      for (int i = 0; i < errorPartCount; ++i)
        EXPECT_EQ(third.parts(x, y, i), onGrid ? every.parts(x, y, i) : 0.0);
    }
  EXPECT_EQ(sumsOf(third).pixels, pixels);
}

TEST(FrameDecomposition, TheReferenceIsThatOfEveryPixelsProbe) {
  const EvenFrame frame("vsm");
  const auto quiet = [](double) {};
  const Image<float> every = referenceOf(frame.drawn, 1, quiet);
  const Image<float> third = referenceOf(frame.drawn, 3, quiet);
  for (int y = 0; y < evenHeight; ++y)
    for (int x = 0; x < evenWidth; ++x) {
      const bool receives = x % 5 != 0, onGrid = x % 3 == 0 && y % 3 == 0;
      EXPECT_EQ(every(x, y), receives ? frame.reference(x, y) : 1.0F) << x << "," << y;
      EXPECT_EQ(third(x, y), onGrid ? every(x, y) : 1.0F) << x << "," << y;
    }
}

TEST(FrameDecomposition, ItsGridIsAsWideAsTheTapsAsk) {
  const EvenFrame frame("vsm");
  const auto receives = [&](int x, int y) { return frame.drawn.surfaces.receivesShadow(x, y); };
  const auto taken = [&](int x, int y) {
    return receives(x, y) && worthDecomposing(frame.drawn.surfaces.visibility(x, y),
                                              frame.reference(x, y), false, {});
  };
  const double taps = tapsOf(frame.drawn, taken) + 0.1 * tapsOf(frame.drawn, receives);
  ASSERT_GT(tapsOf(frame.drawn, taken), 0.0);
  const auto stride = [&](double most) {
    return decompositionStride(frame.drawn, *frame.technique, {}, most);
  };
  EXPECT_EQ(stride(1.01 * taps), 1);
  EXPECT_EQ(stride(taps / 8.5), 3);
}

TEST(FrameDecomposition, TellsHowFarItIsAndCanBeStopped) {
  const EvenFrame frame("vsm");
  double last = -1.0;
  decomposeFrame(frame.drawn, frame.reference, frame.technique, {}, 1, [&](double done) {
    EXPECT_GT(done, last);
    EXPECT_LT(done, 1.0);
    last = done;
  });
  struct Stopped {};
  EXPECT_THROW(decomposeFrame(frame.drawn, frame.reference, frame.technique, {}, 1,
                              [](double) { throw Stopped{}; }),
               Stopped);
}

}  // namespace
}  // namespace umbra

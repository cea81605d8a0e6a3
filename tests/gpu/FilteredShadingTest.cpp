// The shaded frame through mip levels: the footprints and the visibilities of its pixels.
#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

using test::eps;

class FilteredShading : public test::FrameFixture {
 protected:
  ReadPoint readOf(const SurfacePoint& point) const {
    return {settings.read.filter, point.u, point.v, point.footprint};
  }
  bool inside(const SurfacePoint& point) const {
    return point.u >= 0.0 && point.u <= 1.0 && point.v >= 0.0 && point.v <= 1.0;
  }
};

TEST_F(FilteredShading, AgreesWithTheReferenceThroughItsLevels) {
  settings.kernel = {KernelShape::Box, 1};
  for (ReadFilter filter : {ReadFilter::Trilinear, ReadFilter::Anisotropic}) {
    settings.read = {filter, 2};
    for (const char* id : {"hard", "pcf", "vsm", "power-cdf"}) {
      SCOPED_TRACE(std::string(id) + ", " + std::string(nameOf(filter)));
      show(test::slabAndBall(), id);
      const DepthMap& map = renderer->depthMap();
      const Image<float> reference = renderer->reference();
      const test::VisibilityBound bound(*technique, settings.map.format);
      int compared = 0, penumbra = 0, coarser = 0, spread = 0;
      for (int y = 0; y < height; y += 5) {
        for (int x = 0; x < width; x += 5) {
          const auto point = renderer->surfaceAt(x, y);
          if (!point || !inside(*point)) continue;
          const ReadPoint read = readOf(*point);
          const auto visibility = [&](const ReadPoint& at) {
            const Region region = regionOf(map, settings.kernel, at);
            const std::vector<double> channels =
                readChannels(map, *technique, settings.kernel, settings.map.format, at);
            return technique->visibility({channels, region}, point->receiver);
          };
          const auto truth = [&](const ReadPoint& at) {
            return referenceVisibility(regionOf(map, settings.kernel, at), point->receiver);
          };
          const Region region = regionOf(map, settings.kernel, read);
          const std::vector<double> channels =
              readChannels(map, *technique, settings.kernel, settings.map.format, read);
          // Roundings of the blur along two axes, of three for each of up to nine levels, and of
          // the mixes; a sum over the region has as many terms along an axis as it has texels.
          const int reading =
              2 * (2 * settings.kernel.radius + 3) + 3 * 9 + 12 + read.footprint.probes + 2;
          const double summing =
              2 * (4 * std::hypot(read.footprint.x, read.footprint.y) + 32) * eps;
          const double arithmetic = bound({channels, region}, point->receiver, reading) + summing;
          ASSERT_NEAR(point->visibility, visibility(read),
                      arithmetic + test::readError(visibility, read))
              << "pixel " << x << "," << y;
          ASSERT_NEAR(reference(x, y), truth(read), summing + test::readError(truth, read))
              << "pixel " << x << "," << y;
          ++compared;
          penumbra += reference(x, y) > 0.0f && reference(x, y) < 1.0f;
          coarser += std::hypot(read.footprint.x, read.footprint.y) > 2 * read.footprint.probes;
          spread += read.footprint.probes > 1;
        }
      }
      EXPECT_GT(compared, 1000);
      EXPECT_GT(penumbra, 20);
      EXPECT_GT(coarser, 100) << "pixels that read levels above the map";
      EXPECT_EQ(spread > 100, filter == ReadFilter::Anisotropic);
    }
  }
}

// The longer one of the two ways that the position on the map moves along a row and along a column
// of the four pixels that a GPU shades together.
TEST_F(FilteredShading, FootprintsAreTheWayToTheNextPixel) {
  settings.read = {ReadFilter::Anisotropic, 4};
  const auto scene = std::make_shared<Scene>(*test::slabOverGround());
  scene->objects.resize(1);  // one surface, so that neighbouring pixels show it, too
  show(scene, "vsm");
  const Image<float> surfaces = renderer->surfaces().coded();
  const double size = settings.map.size;
  int compared = 0;
  for (int y = 0; y + 1 < height; y += 2) {
    for (int x = 0; x + 1 < width; x += 2) {
      const auto texel = [&](int dx, int dy) {
        return Eigen::Vector2d(size * surfaces(x + dx, y + dy, 0),
                               size * surfaces(x + dx, y + dy, 1));
      };
      bool ground = true;
      for (int i = 0; i < 4; ++i)
        ground = ground && surfaces(x + i % 2, y + i / 2, 0) > 0.0f &&
                 surfaces(x + i % 2, y + i / 2, 0) < 1.0f;
      if (!ground) continue;
      const Footprint footprint = renderer->surfaceAt(x, y)->footprint;
      const Eigen::Vector2d axis(footprint.x, footprint.y);
      // In OpenGL the next row is above.
      double nearest = 1e300, longest = 0.0, shortest = 1e300;
      const Eigen::Vector2d ways[] = {texel(1, 0) - texel(0, 0), texel(1, 1) - texel(0, 1),
                                      texel(0, 0) - texel(0, 1), texel(1, 0) - texel(1, 1)};
      for (const Eigen::Vector2d& way : ways) {
        nearest = std::min(nearest, (way - axis).norm());
        longest = std::max(longest, way.norm());
        shortest = std::min(shortest, way.norm());
      }
      // Where a neighbour is of the ground's other triangle, the GPU takes the way to where this
      // one would go on: two positions interpolated apart, perspective and projected, some sixteen
      // roundings each of coordinates up to one and a half times the map's side.
      const double rounding = 2 * 16 * 1.5 * eps * size;
      ASSERT_LE(nearest, rounding) << "pixel " << x << "," << y;
      // Rows and columns of one group differ by what perspective changes from pixel to pixel.
      ASSERT_GE(axis.norm(), 0.9 * longest) << "pixel " << x << "," << y;
      ASSERT_LE(std::abs(footprint.probes - std::ceil(longest / std::max(shortest, 1.0))), 1.0);
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
}

// The read is checked however coarse the level is.
TEST_F(FilteredShading, APlaneCastsNoShadowOnItself) {
  const auto scene = std::make_shared<Scene>(*test::slabOverGround());
  scene->objects.resize(1);
  for (ReadFilter filter : {ReadFilter::Trilinear, ReadFilter::Anisotropic}) {
    settings.read = {filter, 4};
    settings.kernel = {KernelShape::Box, 1};
    for (const char* id : {"hard", "pcf", "vsm"}) {
      for (double elevation : {45.0, 80.0}) {
        for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
          const double angle = elevation * 3.14159265358979 / 180.0;
          scene->light.kind = kind;
          scene->light.halfAngle = 50;
          scene->light.position = {9 * std::cos(angle), 9 * std::sin(angle), 3};
          show(scene, id);
          const SurfaceImage surfaces = renderer->surfaces();
          for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
              // The weights of all taps add up to 1 but for their rounding: at most 64 texels a
              // row.
              ASSERT_NEAR(surfaces.visibility(x, y), 1.0, 2 * (64 + 2 + 4) * eps)
                  << id << ", " << nameOf(kind) << " at " << elevation << "°, pixel " << x << ","
                  << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace umbra

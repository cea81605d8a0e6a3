// Parallel-split cascades in the shaded frame: which map each pixel is drawn from, and that shadows
// do not change.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"
#include "filters/gpu/ViewColours.h"
#include "tests/gpu/CascadeFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

using Eigen::Vector3d;
using test::Cascaded;
using test::forwardOf;

// Where all windows are the whole map, the picture equals that of one map.
TEST_F(Cascaded, CascadesOfTheWholeMapChangeNothing) {
  settings.map.cascades.count = 1;
  const auto scene = test::slabAndBall();
  scene->camera.position = {0, 25, 50};  // so far away that each part's sphere holds everything
  show(scene, "vsm");
  const SurfaceImage one = renderer->surfaces();
  settings.map.cascades.splitLambda = 0.9;
  settings.map.cascades.frozen = test::slabOverGround()->camera;
  showAgain();
  EXPECT_EQ(renderer->surfaces(), one) << "one map is not split";
  EXPECT_EQ(passes(), "shade view");

  settings.map.cascades = {.count = 4};
  showAgain();
  for (const Cascade& cascade : renderer->cascades()) ASSERT_EQ(cascade.side, 1.0);
  const SurfaceImage four = renderer->surfaces();
  int seams = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(four.coded()(x, y, c), one.coded()(x, y, c));
      // Where two equal visibilities are mixed, their mean is rounded.
      ASSERT_NEAR(four.visibility(x, y), one.visibility(x, y), 4 * test::eps);
      seams += renderer->surfaceAt(x, y).value_or(SurfacePoint{}).nextCascade > 0.0;
    }
  }
  EXPECT_GT(seams, 50);
}

TEST_F(Cascaded, FootprintsReadAtOnceAreThoseOfEveryPixel) {
  settings.read.filter = ReadFilter::Anisotropic;
  show(test::avenue(), "vsm");
  const SurfaceImage image = renderer->surfaces();
  ASSERT_TRUE(image.wide());
  ASSERT_EQ(image.width(), width);
  int surfaces = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto point = renderer->surfaceAt(x, y);
      const auto read = image.at(x, y);
      ASSERT_EQ(read.has_value(), point.has_value());
      if (!point) continue;
      ++surfaces;
      ASSERT_EQ(read->footprint, point->footprint) << x << "," << y;
      ASSERT_EQ(read->cascade, point->cascade) << x << "," << y;
      ASSERT_EQ(read->nextCascade, point->nextCascade) << x << "," << y;
    }
  EXPECT_GT(surfaces, 1000);
  settings.map.cascades.count = 1;
  settings.read.filter = ReadFilter::Bilinear;
  showAgain();
  EXPECT_FALSE(renderer->surfaces().wide());
}

TEST_F(Cascaded, EveryPixelIsDrawnFromTheCascadeOfItsDistance) {
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    SCOPED_TRACE(nameOf(kind));
    const auto scene = test::avenue();
    scene->light.kind = kind;
    scene->light.halfAngle = 50;
    if (kind == LightKind::Spot) scene->light.position = {6, 24, 22};
    show(scene, "vsm");
    const std::vector<Cascade>& cascades = renderer->cascades();
    ASSERT_EQ(cascades.size(), 3u);
    EXPECT_LT(cascades[0].side, 0.6);
    int counts[3] = {}, seams = 0;
    for (int y = 0; y < height; y += 5) {
      for (int x = 0; x < width; x += 5) {
        const auto point = renderer->surfaceAt(x, y);
        if (!point) continue;
        const LightPoint whole = renderer->lightFrame().project(point->world);
        if (!whole.inside) continue;
        const Cascade& own = cascades[std::size_t(point->cascade)];
        const double distance =
            (point->world - scene->camera.position).dot(forwardOf(scene->camera));
        // The world point is computed from the camera's depth buffer, whose error grows with the
        // distance.
        const double slack = 1e-3 * distance;
        EXPECT_LE(own.nearDistance, distance + slack);
        EXPECT_GE(own.farDistance, distance - slack);
        EXPECT_NEAR(point->u, own.u(whole.u), 1e-3 / own.side);
        EXPECT_NEAR(point->v, own.v(whole.v), 1e-3 / own.side);
        const double seam = own.seamDistance(settings.map.cascades.seam);
        if (distance < seam - slack || point->cascade == 2) {
          EXPECT_EQ(point->nextCascade, 0.0);
        }
        if (point->nextCascade > 0.0) {
          EXPECT_NEAR(point->nextCascade, (distance - seam) / (own.farDistance - seam),
                      2 * slack / (own.farDistance - seam));
        }
        ++counts[point->cascade];
        seams += point->nextCascade > 0.0;
      }
    }
    for (int count : counts) EXPECT_GT(count, 20);
    EXPECT_GT(seams, 20);
  }
}

TEST_F(Cascaded, AgreesWithTheReferenceInEveryCascadeAndSeam) {
  settings.map.cascades.seam = 0.3;
  for (const char* id : {"pcf", "vsm", "power-cdf"}) {
    SCOPED_TRACE(id);
    show(test::avenue(), id);
    const Image<float> reference = renderer->reference();
    const test::VisibilityBound bound(*technique, settings.map.format);
    int compared = 0, penumbra = 0, seams = 0;
    for (int y = 0; y < height; y += 3) {
      for (int x = 0; x < width; x += 3) {
        const auto point = renderer->surfaceAt(x, y);
        if (!point || point->u < 0 || point->u > 1 || point->v < 0 || point->v > 1) continue;
        const auto [visibility, moved] = over(*point, [&](const DepthMap& map, double u, double v) {
          return visibilityIn(map, u, v, point->receiver);
        });
        double arithmetic = 4 * test::eps;
        for (const Read& read : readsOf(*point)) {
          const DepthMap& map = renderer->depthMap(read.cascade);
          const std::vector<double> channels =
              readBilinear(map, *technique, settings.kernel, settings.map.format, read.u, read.v);
          arithmetic +=
              read.weight * bound({channels, regionAt(map, read.u, read.v)}, point->receiver);
        }
        ASSERT_NEAR(point->visibility, visibility, arithmetic + moved)
            << "pixel " << x << "," << y << ", cascade " << point->cascade << " + "
            << point->nextCascade;
        const auto [truth, truthMoved] = over(*point, [&](const DepthMap& map, double u, double v) {
          return referenceVisibility(regionAt(map, u, v), point->receiver);
        });
        ASSERT_NEAR(reference(x, y), truth, truthMoved + 32 * test::eps)
            << "pixel " << x << "," << y;
        ++compared;
        penumbra += truth > 0.0 && truth < 1.0;
        seams += point->nextCascade > 0.0 && truth > 0.0 && truth < 1.0;
      }
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(penumbra, 100);
    EXPECT_GT(seams, 10);
  }
}

// A step aside and a turn move each window by whole texels: the depths that two windows share are
// the same but for rounding, which moves edges by far less than a fiftieth of a texel.
TEST_F(Cascaded, DepthsStandStillWhileTheCameraMoves) {
  const auto scene = test::avenue();
  show(scene, "vsm");
  const std::vector<Cascade> before = renderer->cascades();
  std::vector<DepthMap> maps;
  for (int i = 0; i < 3; ++i) maps.push_back(renderer->depthMap(i));

  Camera camera = scene->camera;
  camera.position += Vector3d(0.11, 0.02, -0.07);
  camera.target += Vector3d(0.25, 0.01, -0.07);
  renderer->setCamera(camera);
  renderer->render();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  const int size = settings.map.size;
  int moved = 0;
  for (int i = 0; i < 3; ++i) {
    const Cascade& a = before[std::size_t(i)];
    const Cascade& b = renderer->cascades()[std::size_t(i)];
    ASSERT_EQ(a.side, b.side);
    const int dx = int(std::lround((b.left - a.left) / a.side * size)),
              dy = int(std::lround((b.top - a.top) / a.side * size));
    moved += dx != 0 || dy != 0;
    const DepthMap& old = maps[std::size_t(i)];
    const DepthMap& now = renderer->depthMap(i);
    int shared = 0, edges = 0, different = 0;
    for (int y = std::max(0, dy); y + 1 < size + std::min(0, dy); ++y) {
      for (int x = std::max(0, dx); x + 1 < size + std::min(0, dx); ++x) {
        ++shared;
        edges += std::abs(old(x, y) - old(x + 1, y)) > 0.01 ||
                 std::abs(old(x, y) - old(x, y + 1)) > 0.01;
        // On a slope depth moves with the place, by far less than from texel to texel.
        different += std::abs(old(x, y) - now(x - dx, y - dy)) > 1e-4;
      }
    }
    EXPECT_GT(shared, size * size / 2);
    EXPECT_GT(edges, 50);
    EXPECT_LE(different, edges / 50) << "cascade " << i;
  }
  EXPECT_GT(moved, 0);
}

TEST_F(Cascaded, EveryTechniqueStaysWithinItsBounds) {
  settings.kernel.radius = 1;
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* each : catalogue.all()) {
    for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
      SCOPED_TRACE(std::string(each->info().id) + ", " + std::string(nameOf(kind)));
      const auto scene = test::avenue();
      scene->light.kind = kind;
      scene->light.halfAngle = 50;
      show(scene, each->info().id);
      const SurfaceImage surfaces = renderer->surfaces();
      int shadowed = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          // Also fails for a NaN.
          ASSERT_GE(surfaces.visibility(x, y), 0.0f) << x << "," << y;
          ASSERT_LE(surfaces.visibility(x, y), 1.0f) << x << "," << y;
          shadowed += surfaces.visibility(x, y) < 0.99f;
        }
      }
      EXPECT_GT(shadowed, 100);
    }
  }
}

// The purpose of cascades: near the camera, shadows are nearer to those of the largest map that
// there is.
TEST_F(Cascaded, SharpenWhatIsNear) {
  const auto scene = test::avenue();
  settings.kernel = {KernelShape::Box, 1};
  const auto visibilities = [&](const char* id, int size, int count) {
    settings.map.size = size;
    settings.map.cascades.count = count;
    show(scene, id);
    return renderer->surfaces();
  };
  const SurfaceImage truth = visibilities("hard", MapSettings::largest, 1);
  const SurfaceImage one = visibilities("vsm", 256, 1), three = visibilities("vsm", 256, 3);
  double oneError = 0.0, threeError = 0.0;
  int near = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto point = renderer->surfaceAt(x, y);
      if (!point || point->cascade != 0 || !point->facesLight) continue;
      ++near;
      oneError += std::pow(one.visibility(x, y) - truth.visibility(x, y), 2);
      threeError += std::pow(three.visibility(x, y) - truth.visibility(x, y), 2);
    }
  }
  EXPECT_GT(near, 5000);
  EXPECT_LT(threeError, oneError);
  RecordProperty("rms_one", std::to_string(std::sqrt(oneError / near)));
  RecordProperty("rms_three", std::to_string(std::sqrt(threeError / near)));
}

TEST_F(Cascaded, RedoOnlyWhatChanged) {
  const auto scene = test::avenue();
  show(scene, "vsm");
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  settings.view = ViewMode::Cascades;
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  settings.map.cascades.seam = 0.0;  // without a seam the later windows begin later
  showAgain();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");

  settings.map.cascades.frozen = scene->camera;
  showAgain();
  EXPECT_EQ(passes(), "shade view") << "frozen where the camera is";
  Camera camera = scene->camera;
  camera.position += Vector3d(8, 5, 3);
  renderer->setCamera(camera);
  renderer->render();
  EXPECT_EQ(passes(), "shade view") << "frozen windows stay";
  settings.map.cascades.frozen.reset();
  showAgain();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
}

// The colour of a picture's pixel, without its brightness.
Vector3d hue(const Image<std::uint8_t>& colour, int x, int y) {
  return Vector3d(colour(x, y, 0), colour(x, y, 1), colour(x, y, 2)).normalized();
}

TEST_F(Cascaded, TheViewTintsEachInItsColour) {
  settings.view = ViewMode::Cascades;
  show(test::avenue(), "vsm");
  const Image<std::uint8_t> colour = renderer->colour();
  int seen[3] = {}, mixed = 0;
  for (int y = 0; y < height; y += 2) {
    for (int x = 0; x < width; x += 2) {
      const auto point = renderer->surfaceAt(x, y);
      if (!point || point->u < 0 || point->u > 1 || point->v < 0 || point->v > 1) continue;
      Vector3d expected = Vector3d::Zero();
      for (std::size_t c = 0; c < 3; ++c) {
        expected[int(c)] = cascadeColours[std::size_t(point->cascade)][c];
        if (point->nextCascade > 0.0)
          expected[int(c)] = std::lerp(expected[int(c)],
                                       double(cascadeColours[std::size_t(point->cascade) + 1][c]),
                                       point->nextCascade);
      }
      // A component has eight bits; the largest one is above a hundred.
      ASSERT_LT((hue(colour, x, y) - expected.normalized()).norm(), 0.02) << x << "," << y;
      ++seen[point->cascade];
      mixed += point->nextCascade > 0.2 && point->nextCascade < 0.8;
    }
  }
  for (int count : seen) EXPECT_GT(count, 100);
  EXPECT_GT(mixed, 20);
}

TEST_F(Cascaded, AFrozenViewIsDrawnAndCastsNoShadow) {
  const auto scene = test::avenue();
  Camera above = scene->camera;
  above.position = {30, 35, 40};
  above.target = {0, 0, 0};
  const Camera walker = scene->camera;
  scene->camera = above;
  settings.map.cascades.frozen = walker;
  show(scene, "vsm");
  const SurfaceImage surfaces = renderer->surfaces();
  const Image<std::uint8_t> colour = renderer->colour();
  // The point lies on an edge of the first part's far end, in front of everything behind it.
  const Cascade& first = renderer->cascades()[0];
  const auto corners =
      viewCorners(walker, double(width) / height, first.nearDistance, first.farDistance);
  // Surfaces are drawn from the part of the frozen view that they are in, not from that of the view
  // from above.
  int inFirst = 0;
  for (int y = 0; y < height; y += 4) {
    for (int x = 0; x < width; x += 4) {
      const auto point = renderer->surfaceAt(x, y);
      if (!point || !renderer->lightFrame().project(point->world).inside) continue;
      const double distance = (point->world - walker.position).dot(forwardOf(walker));
      if (point->cascade != 0) continue;
      EXPECT_LE(distance, first.farDistance + 0.1);  // the depth buffer's rounding from afar
      ++inFirst;
    }
  }
  EXPECT_GT(inFirst, 20);
  int drawn = 0, tried = 0;
  for (double t = 0.1; t < 0.95; t += 0.1) {
    const Vector3d onEdge = corners[7] + t * (corners[6] - corners[7]);  // the upper one
    const Eigen::Vector2i pixel = pixelOf(above, onEdge);
    if (pixel.x() < 1 || pixel.y() < 1 || pixel.x() >= width - 1 || pixel.y() >= height - 1)
      continue;
    ++tried;
    const Vector3d line(cascadeColours[0][0], cascadeColours[0][1], cascadeColours[0][2]);
    bool found = false;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        found |= (hue(colour, pixel.x() + dx, pixel.y() + dy) - line.normalized()).norm() < 0.03;
    drawn += found;
  }
  EXPECT_GT(tried, 4);
  EXPECT_EQ(drawn, tried);
  // The lines belong to no surface, and the maps do not contain them.
  std::vector<DepthMap> maps;
  for (int i = 0; i < 3; ++i) maps.push_back(renderer->depthMap(i));
  settings.map.cascades.frozen.reset();
  renderer->setCamera(walker);
  showAgain();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(renderer->depthMap(i), maps[std::size_t(i)]);
  settings.map.cascades.frozen = walker;
  renderer->setCamera(above);
  showAgain();
  EXPECT_EQ(renderer->surfaces(), surfaces);
}

}  // namespace
}  // namespace umbra

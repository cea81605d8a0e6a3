// Errors on surfaces against those of frames that show them.
#include "analysis/surfaces/SurfaceErrors.h"

#include <algorithm>
#include <cmath>

#include "filters/core/maps/ReceiverBias.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

class Surfaces : public test::FrameFixture {
 protected:
  bool onGround(int x, int y) {
    const auto point = renderer->surfaceAt(x, y);
    return point && std::abs(point->world.y()) < 1e-4 && point->facesLight;
  }

  // How far the shader may be off, which takes its plane from the next pixels: their difference is
  // one of floats as large as the distance to the light, `span` apart.
  void expectTheFramesReceivers() {
    const LightFrame light = renderer->lightFrame();
    const ReceiverBias bias(light, settings);
    const double depth = light.farDistance - light.nearDistance;
    int compared = 0;
    for (int y = 2; y < height - 2; y += 7) {
      for (int x = 2; x < width - 2; x += 5) {
        bool plane = true;
        for (int dx : {-1, 0, 1})
          for (int dy : {-1, 0, 1}) plane = plane && onGround(x + dx, y + dy);
        if (!plane) continue;
        const SurfacePoint point = *renderer->surfaceAt(x, y);
        const Eigen::Vector3d beside = renderer->surfaceAt(x + 1, y)->world;
        const Eigen::Vector3d below = renderer->surfaceAt(x, y + 1)->world;
        const double span = std::min((beside - point.world).norm(), (below - point.world).norm());
        const double reach = light.distance(point.world);
        const double expected = bias.receiver(point.world, Eigen::Vector3d::UnitY());
        const double taken = light.project(point.world).z - expected;
        ASSERT_NEAR(point.receiver, expected,
                    taken * 16 * test::eps * reach / span + 32 * test::eps * reach / depth)
            << "pixel " << x << "," << y;
        ++compared;
      }
    }
    EXPECT_GT(compared, 200);
  }
};

TEST_F(Surfaces, ReceiversAreBiasedAsInTheFrame) {
  settings.map.size = 256;
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    for (ReadFilter filter : {ReadFilter::Point, ReadFilter::Bilinear, ReadFilter::SummedArea}) {
      SCOPED_TRACE(std::string(nameOf(kind)) + ", " + std::string(nameOf(filter)));
      settings.read.filter = filter;
      settings.read.satSize = SatSize::Fixed;
      settings.bias.receiverPlane = filter != ReadFilter::Point;
      const auto scene = test::slabAndBall();
      scene->light.kind = kind;
      scene->light.halfAngle = 45;
      show(scene, "vsm");
      expectTheFramesReceivers();
    }
  }
}

// Two slabs above a ground, and a camera below them that looks straight down: every pixel is as
// large a part of the ground, so that the frame's sum and the mesh's are of the same integral.
class Below : public Surfaces {
 protected:
  void SetUp() override {
    Surfaces::SetUp();
    scene = std::make_shared<Scene>(*test::slabOverGround());
    scene->objects.resize(1);
    const auto add = [&](const char* name, const Mesh& mesh) {
      scene->objects.push_back({name, mesh, {}});
    };
    add("lower", test::box({-1.5f, 3.0f, -1.5f}, {1.5f, 3.1f, 1.5f}));
    add("upper", test::box({-0.4f, 6.0f, -0.9f}, {0.7f, 6.1f, 0.8f}));
    scene->camera = {{0, 2.9, 0}, {0, 0, 0}, {0, 0, -1}, 100.0};
    settings.map.size = 64;  // coarse, so that little changes from one pixel to the next
  }

  std::shared_ptr<Scene> scene;
};

// A sum of values that each stand for a cell. It is off by at most the variation within the cells.
struct Sum {
  double value = 0.0, uncertainty = 0.0;
};

TEST_F(Below, TheMeshBleedsAsMuchAsTheFrame) {
  show(scene, "vsm");
  const SurfaceImage surfaces = renderer->surfaces();
  const Image<float> reference = renderer->reference();
  const auto bleeding = [&](int x, int y) {
    EXPECT_TRUE(surfaces.receivesShadow(x, y));
    return std::max(0.0, double(surfaces.visibility(x, y)) - reference(x, y));
  };
  const double side = 2.0 * 2.9 * std::tan(50.0 * 3.14159265358979 / 180.0) / height;
  Sum frame;
  for (int y = 1; y + 1 < height; ++y) {
    for (int x = 1; x + 1 < width; ++x) {
      double least = 1.0, most = 0.0;
      for (int dx : {-1, 0, 1})
        for (int dy : {-1, 0, 1}) {
          least = std::min(least, bleeding(x + dx, y + dy));
          most = std::max(most, bleeding(x + dx, y + dy));
        }
      frame.value += side * side * bleeding(x, y);
      frame.uncertainty += side * side * 0.5 * (most - least);
    }
  }

  const LightFrame light = renderer->lightFrame();
  const SurfaceErrors errors =
      surfaceErrors(surfaceMeshOf(*scene, light, settings.map.size, {.edge = 0.5}),
                    {*scene, light, renderer->depthMap(), settings, *technique});
  const FieldMesh& mesh = errors.mesh;
  const std::vector<float>& atVertices = mesh.vertexFields[3].values;
  ASSERT_EQ(mesh.vertexFields[3].name, "bleeding");
  const SurfaceSums& ground = errors.summary.objects[0];
  Sum onMesh{ground.meanBleeding * ground.area, 0.0};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.objects[i] != 0) continue;
    const auto [a, b, c] = mesh.triangles[i];
    const auto [least, most] = std::minmax({atVertices[a], atVertices[b], atVertices[c]});
    onMesh.uncertainty += double(mesh.faceFields[3].values[i]) * 0.5 * (most - least);
  }
  EXPECT_NEAR(onMesh.value, frame.value, onMesh.uncertainty + frame.uncertainty);
  EXPECT_LT(onMesh.uncertainty + frame.uncertainty, 0.2 * frame.value);
  // The lower slab's 3 × 3, whose penumbra is as dark as it is bright. Its sides end between texels
  // of 10.1 / 64: 3 ± 0.16 each.
  EXPECT_NEAR(ground.shadowedArea, 9.0, 6.16 * 0.16);
}

}  // namespace
}  // namespace umbra

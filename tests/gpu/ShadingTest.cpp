// The shaded frame: which light's part it darkens, and by how much.
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>

#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

class Shading : public test::FrameFixture {
 protected:
  // The visibility of one read, evaluated by the reference.
  double visibilityAt(double u, double v, double receiver) {
    const DepthMap& map = renderer->depthMap();
    const Region region = regionBilinear(map, settings.kernel, u, v);
    const std::vector<double> channels =
        readBilinear(map, *technique, settings.kernel, settings.map.format, u, v);
    return technique->visibility({channels, region}, receiver);
  }
  double referenceAt(double u, double v, double receiver) {
    return referenceVisibility(regionBilinear(renderer->depthMap(), settings.kernel, u, v),
                               receiver);
  }

  // How far `evaluate(u, v)` moves when the read's position is off by four float roundings: the
  // picture keeps u and v, and multiplies them by the size of the map.
  template <class Evaluate>
  static double positionError(const Evaluate& evaluate, double u, double v) {
    double error = 0.0;
    const double exact = evaluate(u, v);
    for (double du : {-4 * test::eps, 4 * test::eps})
      for (double dv : {-4 * test::eps, 4 * test::eps})
        error = std::max(error, std::abs(evaluate(u + du, v + dv) - exact));
    return 2 * error;
  }
};

TEST_F(Shading, AgreesWithTheReferenceAtEveryKindOfPixel) {
  settings.map.size = 128;  // coarse, so that many pixels lie in penumbrae
  for (const char* id : {"hard", "pcf", "vsm", "power-cdf"}) {
    for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
      SCOPED_TRACE(std::string(id) + ", " + std::string(nameOf(kind)));
      const auto scene = test::slabAndBall();
      scene->light.kind = kind;
      scene->light.halfAngle = 45;
      show(scene, id);
      const SurfaceImage surfaces = renderer->surfaces();
      const Image<float> reference = renderer->reference();
      const test::VisibilityBound bound(*technique, settings.map.format);
      int compared = 0, penumbra = 0;
      for (int y = 0; y < height; y += 3) {
        for (int x = 0; x < width; x += 3) {
          const auto surface = surfaces.at(x, y);
          if (!surface || !surface->isInMap()) continue;
          const double u = surface->u, v = surface->v, receiver = surface->receiver;
          const DepthMap& map = renderer->depthMap();
          const Region region = regionBilinear(map, settings.kernel, u, v);
          const std::vector<double> channels =
              readBilinear(map, *technique, settings.kernel, settings.map.format, u, v);
          const auto visibility = [&](double a, double b) { return visibilityAt(a, b, receiver); };
          const auto truth = [&](double a, double b) { return referenceAt(a, b, receiver); };
          // Stored channels carry the prefilter's rounding as well.
          const double arithmetic = bound({channels, region}, receiver);
          ASSERT_NEAR(surfaces.visibility(x, y), visibility(u, v),
                      arithmetic + positionError(visibility, u, v))
              << "pixel " << x << "," << y;
          ASSERT_NEAR(reference(x, y), truth(u, v), positionError(truth, u, v) + 32 * test::eps)
              << "pixel " << x << "," << y;
          ++compared;
          if (reference(x, y) > 0.0f && reference(x, y) < 1.0f) ++penumbra;
        }
      }
      EXPECT_GT(compared, 1000);
      EXPECT_GT(penumbra, 20);
    }
  }
}

// In full shadow a surface looks as VTK draws it without the casting light; where it is lit, as
// VTK draws it with all of them. Phong and physically based materials alike.
TEST_F(Shading, DarkensTheCastingLightAndNoOther) {
  for (bool physicallyBased : {false, true}) {
    for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
      SCOPED_TRACE(std::string(physicallyBased ? "PBR, " : "Phong, ") + std::string(nameOf(kind)));
      const auto scene = test::slabAndBall();
      for (SceneObject& object : scene->objects) object.material.physicallyBased = physicallyBased;
      scene->light.kind = kind;
      scene->light.halfAngle = 45;
      show(scene, "hard");
      const SurfaceImage surfaces = renderer->surfaces();
      const Image<std::uint8_t> shadowed = renderer->colour();

      renderer->renderer().SetPass(nullptr);  // VTK draws alone
      window->Render();
      const Image<std::uint8_t> lit = renderer->colour();
      vtkLight* casting =
          vtkLight::SafeDownCast(renderer->renderer().GetLights()->GetItemAsObject(0));
      casting->SetIntensity(0.0);
      window->Render();
      const Image<std::uint8_t> unlit = renderer->colour();

      int dark = 0, bright = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          if (!surfaces.shows(x, y)) continue;
          const float visibility = surfaces.visibility(x, y);
          ASSERT_TRUE(visibility == 0.0f || visibility == 1.0f);
          (visibility == 0.0f ? dark : bright) += 1;
          const Image<std::uint8_t>& expected = visibility == 0.0f ? unlit : lit;
          for (int c = 0; c < 3; ++c)  // both are rounded to eight bits
            ASSERT_NEAR(int(shadowed(x, y, c)), int(expected(x, y, c)), 1)
                << "pixel " << x << "," << y << ", visibility " << visibility;
        }
      }
      EXPECT_GT(dark, 300);
      EXPECT_GT(bright, 10000);
    }
  }
}

// A single plane blocks nothing of itself, however wide the kernel is and however the light slants
// (down to the angle at which the bias reaches its limit).
TEST_F(Shading, APlaneCastsNoShadowOnItself) {
  const auto scene = std::make_shared<Scene>(*test::slabOverGround());
  scene->objects.resize(1);
  for (const char* id : {"hard", "pcf", "vsm"}) {
    for (double elevation : {25.0, 45.0, 80.0}) {
      for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
        for (int radius : {1, 5}) {
          settings.kernel = {KernelShape::Box, radius};
          const double angle = elevation * 3.14159265358979 / 180.0;
          scene->light.kind = kind;
          scene->light.halfAngle = 50;
          scene->light.position = {9 * std::cos(angle), 9 * std::sin(angle), 3};
          show(scene, id);
          const SurfaceImage surfaces = renderer->surfaces();
          for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
              // The weights of all taps add up to 1 but for their rounding.
              ASSERT_NEAR(surfaces.visibility(x, y), 1.0, 2 * (2 * radius + 4) * test::eps)
                  << id << ", " << nameOf(kind) << " at " << elevation << "°, " << radius
                  << " texels, pixel " << x << "," << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace umbra

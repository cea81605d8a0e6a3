// What the picture draws over the scene, and where its first probe goes: geometry without a
// picture.
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QRect>
#include <cmath>

#include "analysis/errors/WorstPixel.h"
#include "ui/picture/Footprint.h"
#include "ui/picture/LightHandle.h"
#include "ui/picture/SceneProjection.h"

namespace umbra {
namespace {

TEST(PictureGeometry, TheWorstSpotIsInFullShadow) {
  SurfaceImage surfaces(200, 150);
  Image<float> reference(200, 150, 1, 1.0F);
  SurfacePoint surface{.u = 0.5, .v = 0.5, .receiver = 0.5};
  const auto fill = [&](QRect spot, float visibility, float truth) {
    for (int y = spot.top(); y <= spot.bottom(); ++y)
      for (int x = spot.left(); x <= spot.right(); ++x) {
        surface.visibility = visibility;
        surfaces.set(x, y, surface);
        reference(x, y) = truth;
      }
  };
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) surfaces.set(x, y, surface);
  EXPECT_FALSE(worstBleeding(surfaces, reference));
  fill({30, 40, 40, 40}, 0.9F, 0.4F);   // a penumbra, further off than what follows
  fill({120, 60, 40, 40}, 0.0F, 0.0F);  // full shadow
  fill({130, 70, 20, 20}, 0.3F, 0.0F);  // in which light bleeds
  fill({140, 80, 1, 1}, 0.35F, 0.0F);   // here most
  fill({60, 120, 1, 1}, 1.0F, 0.0F);    // a stray pixel
  const auto worst = worstBleeding(surfaces, reference);
  ASSERT_TRUE(worst.has_value());
  EXPECT_EQ(worst->x, 140);
  EXPECT_EQ(worst->y, 80);
}

TEST(PictureGeometry, AFootprintLiesOnItsSurface) {
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d(-2, 0, -2), Eigen::Vector3d(2, 3, 2));
  DepthMap map(64, 64, 1, 0.5);
  const Region region = regionAtTexel(map, {KernelShape::Box, 2, 0.0}, 30, 20);
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    Light light;
    light.kind = kind;
    light.position = {2.0, 8.0, 1.0};
    const LightFrame frame = fitLightFrame(light, bounds);
    const Plane ground(Eigen::Vector3d::UnitY(), Eigen::Vector3d::Zero());
    const auto outline = footprintOf(region, 64, 0.5, frame, ground);
    EXPECT_GE(outline.size(), 4u);
    double left = 1.0, right = 0.0;
    for (const Eigen::Vector3d& corner : outline) {
      EXPECT_LT(std::abs(corner.y()), 1e-9);
      const LightPoint point = frame.project(corner);
      left = std::min(left, point.u);
      right = std::max(right, point.u);
    }
    // Texels 28 to 32 of 64.
    EXPECT_LT(std::abs(left - 28.0 / 64.0), 1e-9);
    EXPECT_LT(std::abs(right - 33.0 / 64.0), 1e-9);
  }
}

TEST(PictureGeometry, ADirectionalLightTurnsAboutItsTarget) {
  const vtkNew<vtkRenderer> renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 4, 20);
  camera->SetFocalPoint(0, 2, 0);
  camera->SetClippingRange(1, 100);
  const SceneProjection projection(*renderer, {800, 600});
  const Eigen::Vector3d point(1.0, 2.0, -3.0);
  const QPointF before = *projection.toWidget(point);
  const QPointF after = *projection.toWidget(projection.moved(point, {30, -12}));
  EXPECT_LT(std::abs(after.x() - before.x() - 30), 1e-6);
  EXPECT_LT(std::abs(after.y() - before.y() + 12), 1e-6);
  EXPECT_FALSE(projection.toWidget(Eigen::Vector3d(0, 4, 30)));  // behind the camera

  Light light;
  light.position = {3.0, 9.0, 0.0};  // above the picture: the handle stands at its border
  LightHandle handle;
  handle.place(light, light.target, projection);
  ASSERT_TRUE(handle.position().has_value());
  EXPECT_TRUE(QRectF(0, 0, 800, 600).contains(*handle.position()));
  EXPECT_TRUE(handle.isAt(*handle.position() + QPointF(5, 5)));
  const Light turned = handle.dragged(light, {40, 0}, projection);
  EXPECT_LT(std::abs((turned.position - turned.target).norm() - light.position.norm()), 1e-9);
  EXPECT_GT(turned.position.x(), light.position.x());
  light.kind = LightKind::Spot;
  const Light moved = handle.dragged(light, {0, 0}, projection);
  EXPECT_LT((moved.position - light.position).norm(), 1e-9);
}

}  // namespace
}  // namespace umbra

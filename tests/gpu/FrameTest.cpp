// What a frame recomputes, hands out and leaves unchanged.
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "filters/core/support/Error.h"
#include "tests/gpu/FrameFixture.h"

namespace umbra {
namespace {

using Frame = test::FrameFixture;

TEST_F(Frame, RedoesOnlyWhatChanged) {
  const auto scene = test::slabAndBall();
  show(scene, "vsm");
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  renderer->render();
  EXPECT_EQ(passes(), "shade view");

  Camera camera = scene->camera;
  camera.position.x() += 1.0;
  renderer->setCamera(camera);
  renderer->render();
  EXPECT_EQ(passes(), "shade view") << "moving the camera bakes nothing";

  settings.view = ViewMode::Error;
  settings.bias.constant *= 2.0;
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  settings.kernel.radius += 1;
  showAgain();
  EXPECT_EQ(passes(), "prefilter shade view");
  settings.read.filter = ReadFilter::Trilinear;
  showAgain();
  EXPECT_EQ(passes(), "levels shade view");
  settings.read = {ReadFilter::Anisotropic, 4};
  showAgain();
  EXPECT_EQ(passes(), "shade view") << "the same levels";
  settings.kernel.radius -= 1;
  showAgain();
  EXPECT_EQ(passes(), "prefilter levels shade view");
  settings.read.filter = ReadFilter::Bilinear;
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  settings.map.format = StorageFormat::Half;
  showAgain();
  EXPECT_EQ(passes(), "encode prefilter shade view");
  renderer->setTechnique(*allTechniques().make("esm"));
  renderer->render();
  EXPECT_EQ(passes(), "encode prefilter shade view");
  renderer->setTechnique(*allTechniques().make("esm"));
  renderer->setLight(scene->light);
  renderer->render();
  EXPECT_EQ(passes(), "shade view") << "the same technique and light again";

  Light light = scene->light;
  light.position.x() -= 1.0;
  renderer->setLight(light);
  renderer->render();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  settings.map.size = 256;
  showAgain();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  EXPECT_EQ(renderer->depthMap().width(), 256);
}

TEST_F(Frame, ReadBacksHaveTheirTopRowFirst) {
  const auto scene = test::slabOverGround();
  show(scene, "vsm");
  // These are two corners of the ground that differ in both coordinates, and the slab's top.
  for (const Eigen::Vector3d& world :
       {Eigen::Vector3d(-4, 0, 4), Eigen::Vector3d(-3, 0, -4), Eigen::Vector3d(1.8, 1.2, -1.2)}) {
    const Eigen::Vector2i pixel = pixelOf(scene->camera, world);
    const auto surface = renderer->surfaceAt(pixel.x(), pixel.y());
    ASSERT_TRUE(surface.has_value());
    // One pixel covers 0.05 units at most here, more along the ground's slant.
    EXPECT_LT((surface->world - world).norm(), 0.1);
    const LightPoint point = renderer->lightFrame().project(surface->world);
    EXPECT_NEAR(surface->u, point.u, 1e-5);
    EXPECT_NEAR(surface->v, point.v, 1e-5);
    EXPECT_LE(surface->receiver, point.z);
    EXPECT_GT(surface->receiver, point.z - 0.02);
    EXPECT_TRUE(surface->facesLight);
    const auto read = renderer->surfaces().at(pixel.x(), pixel.y());
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->u, surface->u);
    EXPECT_EQ(read->visibility, surface->visibility);
  }
  EXPECT_FALSE(renderer->surfaceAt(0, 0).has_value()) << "sky";
  EXPECT_FALSE(renderer->surfaceAt(-1, 5).has_value());
  const Image<std::uint8_t> colour = renderer->colour();
  const Eigen::Vector2i slab = pixelOf(scene->camera, {2, 1.2, -1.5});
  EXPECT_GT(colour(slab.x(), slab.y(), 0), colour(slab.x(), slab.y(), 2) + 40) << "brown";
}

TEST_F(Frame, KnowsWhatFacesAwayFromTheLight) {
  const auto scene = test::slabAndBall();
  scene->light.position = {5, 8, -6};  // the light shines from behind
  show(scene, "vsm");
  // This is the low side of the ball, towards the camera.
  const Eigen::Vector3d world =
      Eigen::Vector3d(-1.5, 1, 1) + Eigen::Vector3d(-0.3, -0.6, 0.74).normalized();
  const Eigen::Vector2i pixel = pixelOf(scene->camera, world);
  const auto surface = renderer->surfaceAt(pixel.x(), pixel.y());
  ASSERT_TRUE(surface.has_value());
  EXPECT_FALSE(surface->facesLight);
  EXPECT_FALSE(renderer->surfaces().receivesShadow(pixel.x(), pixel.y()));
  EXPECT_LT(renderer->surfaces().coded()(pixel.x(), pixel.y(), 2), 0.0f) << "as files hold it";
}

TEST_F(Frame, DrawsOthersPropsWithoutShadowOfTheirs) {
  const auto scene = test::slabOverGround();
  show(scene, "vsm");
  const DepthMap before = renderer->depthMap();
  const SurfaceImage surfacesBefore = renderer->surfaces();

  // There is a green upright card in front of the ground's centre.
  vtkNew<vtkPoints> points;
  for (const auto& [x, y] : {std::pair{-1.0, 0.5}, {1.0, 0.5}, {1.0, 2.0}, {-1.0, 2.0}})
    points->InsertNextPoint(x, y, 2.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> card;
  card->SetPoints(points);
  card->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(card);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 1, 0);
  actor->GetProperty()->LightingOff();
  renderer->renderer().AddActor(actor);
  renderer->setLight(scene->light);
  settings.map.size = 512;  // this makes the map stale
  showAgain();
  settings.map.size = 1024;
  showAgain();

  EXPECT_EQ(renderer->depthMap(), before);
  EXPECT_EQ(renderer->surfaces(), surfacesBefore);
  const Eigen::Vector2i pixel = pixelOf(scene->camera, {0, 1.2, 2});
  const Image<std::uint8_t> colour = renderer->colour();
  EXPECT_EQ(colour(pixel.x(), pixel.y(), 0), 0);
  EXPECT_EQ(colour(pixel.x(), pixel.y(), 1), 255);

  // Behind the slab the card is hidden, since the scene's depth is handed on.
  actor->SetPosition(2.0, -0.4, -4.5);
  renderer->render();
  const Eigen::Vector2i slab = pixelOf(scene->camera, {2, 1.1, -1});
  EXPECT_LT(renderer->colour()(slab.x(), slab.y(), 1), 200);
  renderer->renderer().RemoveActor(actor);
}

TEST_F(Frame, ShowsTheSignOfTheErrorInColour) {
  settings.view = ViewMode::Error;
  settings.map.size = 128;
  show(test::slabAndBall(), "vsm");
  const SurfaceImage surfaces = renderer->surfaces();
  const Image<float> reference = renderer->reference();
  const Image<std::uint8_t> colour = renderer->colour();
  int neutral = 0, red = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto surface = surfaces.at(x, y);
      if (!surface || !surface->facesLight) continue;
      const float error = surfaces.visibility(x, y) - reference(x, y);
      const int balance = int(colour(x, y, 0)) - int(colour(x, y, 2));
      if (error == 0.0f) {
        ++neutral;
        ASSERT_EQ(balance, 0) << x << "," << y;
      } else if (error > 0.05f) {
        ++red;
        ASSERT_GT(balance, 3) << x << "," << y;
      }
    }
  }
  EXPECT_GT(neutral, 1000);
  EXPECT_GT(red, 20);
}

// The colour of bleeding has no green: what is left of it tells how far an error is from the range.
TEST_F(Frame, ShowsAnErrorOfTheRangesSizeInFullColour) {
  settings.view = ViewMode::Error;
  settings.map.size = 128;
  show(test::slabAndBall(), "vsm");
  const Image<std::uint8_t> whole = renderer->colour();
  settings.errorRange = 0.05;
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  const SurfaceImage surfaces = renderer->surfaces();
  const Image<float> reference = renderer->reference();
  const Image<std::uint8_t> narrow = renderer->colour();
  int full = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!surfaces.receivesShadow(x, y)) continue;
      const float error = surfaces.visibility(x, y) - reference(x, y);
      if (error < 0.05f || error > 0.9f) continue;
      ++full;
      ASSERT_EQ(int(narrow(x, y, 1)), 0) << x << "," << y;
      ASSERT_GT(int(whole(x, y, 1)), 0) << x << "," << y;
    }
  EXPECT_GT(full, 20);
}

TEST_F(Frame, AnotherRendererMayFollowInTheSameWindow) {
  show(test::slabOverGround(), "vsm");
  const Image<std::uint8_t> first = renderer->colour();
  show(test::slabAndBall(), "power-cdf");
  show(test::slabOverGround(), "vsm");
  EXPECT_EQ(renderer->colour(), first);
}

// The second renderer has a context of its own, as those of the window's panes have.
TEST_F(Frame, SnapshotsShareTheDepthMapsThatAreTheSame) {
  const auto scene = test::slabAndBall();
  settings.map.size = 128;
  settings.map.cascades.count = 2;
  show(scene, "vsm");
  const auto first = renderer->snapshot();
  const vtkSmartPointer<vtkRenderWindow> other = makeHeadlessWindow(width, height);
  std::optional<ShadowRenderer> pane(std::in_place, *other);
  pane->setScene(scene);
  pane->setTechnique(*allTechniques().make("msm"));
  FrameSettings its = settings;
  its.bias.constant *= 2.0;
  Light light = scene->light;
  Camera camera = scene->camera;
  const auto shared = [&] {
    pane->setLight(light);
    pane->setCamera(camera);
    pane->setFrame(its);
    pane->render();
    const auto snapshot = pane->snapshot(&*renderer);
    EXPECT_EQ(snapshot->surfaces, pane->surfaces());
    EXPECT_EQ(snapshot->maps.size(), snapshot->cascades.size());
    for (int i = 0; i < int(snapshot->maps.size()); ++i)
      EXPECT_EQ(*snapshot->maps[i], pane->depthMap(i)) << "shared or not, they are its own depths";
    return snapshot->maps == first->maps;
  };
  EXPECT_TRUE(shared()) << "another technique and bias";
  its.map.format = StorageFormat::Half;
  EXPECT_TRUE(shared()) << "depths are kept in floats whatever the channels are";

  camera.position = 0.5 * (camera.position + camera.target);
  EXPECT_FALSE(shared()) << "cascades follow the camera";
  camera = scene->camera;
  light.position.x() -= 1.0;
  EXPECT_FALSE(shared());
  light = scene->light;
  for (const auto change : {+[](FrameSettings& s) { s.map.size = 64; },
                            // The windows of cascades hold what the filter reaches.
                            +[](FrameSettings& s) { s.kernel.radius += 2; },
                            +[](FrameSettings& s) { s.map.cascades.count = 1; },
                            +[](FrameSettings& s) { s.bias.cullFrontFaces = true; }}) {
    const FrameSettings before = its;
    change(its);
    EXPECT_FALSE(shared());
    its = before;
  }
  EXPECT_TRUE(shared());
  pane->setScene(test::slabOverGround());
  EXPECT_FALSE(shared());
  pane.reset();
}

TEST_F(Frame, ReadingBackBeforeAFrameIsAnError) {
  ShadowRenderer empty(*window);
  EXPECT_THROW(empty.surfaces(), Error);
  EXPECT_THROW(empty.depthMap(), Error);
}

TEST_F(Frame, ABrokenShaderIsAnErrorThatNamesTheTechnique) {
  class Broken final : public TechniqueWith<Broken, NoParameters> {
    const TechniqueInfo& info() const override {
      static constexpr TechniqueInfo info{.id = "broken", .title = "Broken"};
      return info;
    }
    std::vector<Channel> channels() const override { return {{"z"}}; }
    void encode(double z, std::span<double> channels) const override { channels[0] = z; }
    double visibility(const Fetch&, double) const override { return 1.0; }
    Trace explain(const Fetch&, double) const override {
      Trace trace;
      trace.steps = {{"v", "always lit", "", 1.0}};
      return trace;
    }
    std::string_view glsl() const override { return "void umbraEncode("; }
    std::string_view page() const override { return ""; }
  };
  show(test::slabOverGround(), "vsm");
  renderer->setTechnique(Broken());
  try {
    renderer->render();
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("broken"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  // The compiler's message is an OpenGL error too; it must be the only one.
  EXPECT_EQ(glErrors->messages().size(), 1u);
  glErrors.reset();
  glErrors.emplace();
}

}  // namespace
}  // namespace umbra

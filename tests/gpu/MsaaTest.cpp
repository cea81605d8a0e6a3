// Depth maps with several samples a texel, against the geometry at the driver's sample positions.
#include <vtkNew.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "filters/gpu/SceneActors.h"
#include "filters/gpu/vtkUmbraDepthPass.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/Rounding.h"
#include "tests/gpu/TestScenes.h"

namespace umbra {
namespace {

constexpr int mapSize = 40;

class Msaa : public test::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    window->AddRenderer(renderer);
    given = vtkUmbraDepthPass::SamplesGiven(4);
    ASSERT_GT(given, 1) << "this driver has no multisampled float textures";
  }
  void TearDown() override {
    window->MakeCurrent();
    actors.removeFrom(*renderer);
    pass->ReleaseGraphicsResources(window);
    target = gl::Texture();
    GpuTest::TearDown();
  }

  // Draws the scene into layers `first` … of an array that has one more on either side.
  void draw(const std::shared_ptr<Scene>& scene, int samples, int first = 1) {
    actors.setScene(*scene, *renderer);
    frame = fitLightFrame(scene->light, scene->lightBounds());
    window->Render();
    target = gl::Texture(GL_R32F, mapSize, mapSize, first + samples + 1);
    target.upload(1, std::vector<float>(texels * std::size_t(target.layers()), -1.0f));
    pass->SetCaster(actors.caster());
    pass->SetLightFrame(frame);
    pass->SetTarget(&target, first);
    pass->SetSamples(samples);
    vtkRenderState state(renderer);
    pass->Render(&state);
    depths = target.read(1);
  }

  float depth(int x, int y, int layer) const {
    return depths[std::size_t(layer) * texels + std::size_t(y) * mapSize + x];
  }

  // The samples' places in a texel, from its top-left corner, as the driver gives them for the
  // framebuffer that is bound. Row 0 of that framebuffer is the map's top row.
  std::vector<Eigen::Vector2d> samplePlaces(int samples) {
    gl::MultisampleTexture texture;
    texture.require(GL_R32F, mapSize, mapSize, samples);
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    const gl::FramebufferHandle framebuffer(name);
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, texture.name(), 0);
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    std::vector<Eigen::Vector2d> places;
    for (int sample = 0; sample < samples; ++sample) {
      float place[2] = {0.0f, 0.0f};
      glGetMultisamplefv(GL_SAMPLE_POSITION, GLuint(sample), place);
      places.push_back({place[0], place[1]});
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(before));
    return places;
  }

  static constexpr std::size_t texels = std::size_t(mapSize) * mapSize;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkUmbraDepthPass> pass;
  SceneActors actors;
  LightFrame frame;
  gl::Texture target;
  std::vector<float> depths;
  int given = 1;
};

// One rectangle under a light that shines aslant, so that depth changes within a texel.
std::shared_ptr<Scene> slantedPlane(LightKind kind) {
  auto scene = std::make_shared<Scene>();
  SceneObject ground;
  ground.mesh = test::rectangle({-5, 0, -5}, {0, 0, 10}, {10, 0, 0});
  scene->objects = {ground};
  scene->light.kind = kind;
  scene->light.position = {5, 8, 3};
  scene->light.halfAngle = 50;
  return scene;
}

// The depth of the ground y = 0 at (u, v) of the map; 1 beside it.
double planeDepth(const LightFrame& frame, double u, double v) {
  const Eigen::Vector3d near = frame.unproject(u, v, 0.0), far = frame.unproject(u, v, 1.0);
  const double t = near.y() / (near.y() - far.y());
  const Eigen::Vector3d hit = near + t * (far - near);
  const bool on = std::abs(hit.x()) <= 5.0 && std::abs(hit.z()) <= 5.0;
  return on && t > 0.0 ? frame.project(hit).z : 1.0;
}

// Whether only the plane, or nothing at all, lies within a texel of (x, y).
bool awayFromEdge(const LightFrame& frame, int x, int y) {
  int on = 0;
  for (int j = -1; j <= 2; ++j)
    for (int i = -1; i <= 2; ++i)
      on += planeDepth(frame, double(x + i) / mapSize, double(y + j) / mapSize) < 1.0;
  return on == 0 || on == 16;
}

TEST_F(Msaa, EverySampleHasTheDepthOfItsOwnPlace) {
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    SCOPED_TRACE(std::string(nameOf(kind)));
    draw(slantedPlane(kind), given);
    const std::vector<Eigen::Vector2d> places = samplePlaces(given);
    // World coordinates up to 12 through a matrix product, an interpolation and a length; an
    // interpolated place is on a grid of 1/256 texel, over which the plane's depth changes less
    // than 2/256 of what it does over a texel along both axes.
    const double roundings = 16 * test::eps * 12.0 / (frame.farDistance - frame.nearDistance);
    int compared = 0;
    for (int y = 0; y < mapSize; ++y) {
      for (int x = 0; x < mapSize; ++x) {
        if (!awayFromEdge(frame, x, y)) continue;
        ++compared;
        const auto exact = [&](double dx, double dy) {
          return planeDepth(frame, (x + dx) / mapSize, (y + dy) / mapSize);
        };
        const double gain =
            std::abs(exact(1, 0) - exact(0, 0)) + std::abs(exact(0, 1) - exact(0, 0));
        for (int sample = 0; sample < given; ++sample)
          ASSERT_NEAR(depth(x, y, 1 + sample), exact(places[sample].x(), places[sample].y()),
                      roundings + gain / 256)
              << "sample " << sample << " of texel " << x << "," << y;
      }
    }
    EXPECT_GT(compared, int(texels) / 3);
  }
}

TEST_F(Msaa, AnEdgeCoversTheSamplesInsideIt) {
  auto scene = test::slabOverGround();
  const Eigen::Vector3d corner(-1.13, 1, -2), edgeA(1.1, 0, 2.3), edgeB(2.1, 0, -1.0);
  scene->objects[1].mesh =
      test::rectangle(corner.cast<float>(), edgeA.cast<float>(), edgeB.cast<float>());
  draw(scene, given);
  const std::vector<Eigen::Vector2d> places = samplePlaces(given);
  const double high = frame.project(corner).z, ground = frame.project({0, 0, 0}).z;
  const double tolerance = 16 * test::eps * 12.0 / (frame.farDistance - frame.nearDistance);
  Eigen::Matrix2d edges;
  edges << edgeA.x(), edgeB.x(), edgeA.z(), edgeB.z();
  int partly = 0, grounded = 0;
  for (int y = 0; y < mapSize; ++y) {
    for (int x = 0; x < mapSize; ++x) {
      int covered = 0;
      for (int sample = 0; sample < given; ++sample) {
        const Eigen::Vector3d world = frame.unproject((x + places[sample].x()) / mapSize,
                                                      (y + places[sample].y()) / mapSize, high) -
                                      corner;
        const Eigen::Vector2d along = edges.inverse() * Eigen::Vector2d(world.x(), world.z());
        const double inside = std::min(along.minCoeff(), 1.0 - along.maxCoeff());
        // A texel is a tenth of the shorter edge; vertices snap to a 256th of it.
        if (std::abs(inside) < 0.1 / 128) continue;
        covered += inside > 0.0;
        const double z = depth(x, y, 1 + sample);
        if (z == 1.0 && inside < 0.0) continue;  // beside the ground
        grounded += inside < 0.0;
        ASSERT_NEAR(z, inside > 0.0 ? high : ground, tolerance)
            << "sample " << sample << " of texel " << x << "," << y;
      }
      partly += covered > 0 && covered < given;
    }
  }
  EXPECT_GT(partly, 20);
  EXPECT_GT(grounded, mapSize * mapSize);  // there are `given` samples a texel
}

TEST_F(Msaa, OnlyItsOwnLayersAreWritten) {
  for (int samples : {1, given}) {
    draw(slantedPlane(LightKind::Directional), samples, 2);
    for (int layer : {0, 1, 2 + samples})
      EXPECT_TRUE(std::all_of(depths.begin() + layer * texels,
                              depths.begin() + (layer + 1) * texels,
                              [](float z) { return z == -1.0f; }))
          << "layer " << layer << " with " << samples << " samples";
    for (int layer = 2; layer < 2 + samples; ++layer)
      EXPECT_TRUE(std::all_of(depths.begin() + layer * texels,
                              depths.begin() + (layer + 1) * texels,
                              [](float z) { return z >= 0.0f && z <= 1.0f; }))
          << "layer " << layer << " with " << samples << " samples";
  }
}

// Drawing several samples in between changes nothing afterwards.
TEST_F(Msaa, OneSampleIsAsItWas) {
  const auto scene = test::slabAndBall();
  draw(scene, 1);
  const std::vector<float> before = depths;
  draw(scene, given);
  draw(scene, 1);
  EXPECT_EQ(depths, before);
  gl::Texture plain(GL_R32F, mapSize, mapSize);
  pass->SetTarget(&plain);
  vtkRenderState state(renderer);
  pass->Render(&state);
  const std::vector<float> alone = plain.read(1);
  EXPECT_TRUE(std::equal(alone.begin(), alone.end(), before.begin() + texels));
}

TEST_F(Msaa, TheDriverSaysHowManySamplesItGives) {
  EXPECT_EQ(vtkUmbraDepthPass::SamplesGiven(1), 1);
  for (int asked : {2, 4, 8}) {
    const int samples = vtkUmbraDepthPass::SamplesGiven(asked);
    gl::MultisampleTexture texture;
    texture.require(GL_R32F, mapSize, mapSize, samples);
    GLint real = 0;
    glGetTextureLevelParameteriv(texture.name(), 0, GL_TEXTURE_SAMPLES, &real);
    EXPECT_EQ(real, samples) << "asked for " << asked;
  }
}

}  // namespace
}  // namespace umbra

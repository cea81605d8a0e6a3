#include "datasets/scenes/SceneCatalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "filters/core/scene/ClosedBody.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

std::vector<SceneInfo> availableScenes() {
  std::vector<SceneInfo> infos = sceneCatalogue();
  std::erase_if(infos, [](const SceneInfo& info) { return !info.missing.empty(); });
  return infos;
}

bool sameMesh(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.triangles == b.triangles;
}

bool sameObjects(const Scene& a, const Scene& b) {
  return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    [](const SceneObject& x, const SceneObject& y) {
                      return x.name == y.name && sameMesh(x.mesh, y.mesh);
                    });
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

class EveryScene : public testing::TestWithParam<SceneInfo> {};

TEST_P(EveryScene, IsTheSameWhenBuiltTwice) {
  const Scene first = makeScene(GetParam().name), second = makeScene(GetParam().name);
  EXPECT_TRUE(sameObjects(first, second));
  EXPECT_EQ(first.light, second.light);
  EXPECT_EQ(first.camera, second.camera);
}

TEST_P(EveryScene, HasSoundMeshes) {
  const Scene scene = makeScene(GetParam().name);
  ASSERT_FALSE(scene.objects.empty());
  std::set<std::string> names;
  for (const SceneObject& object : scene.objects) {
    SCOPED_TRACE(object.name);
    EXPECT_TRUE(names.insert(object.name).second) << "two objects share a name";
    const Mesh& mesh = object.mesh;
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    EXPECT_TRUE(std::all_of(mesh.positions.begin(), mesh.positions.end(),
                            [](const Eigen::Vector3f& p) { return p.allFinite(); }));
    // Three squares and a root in single precision are right to a few units in the last place.
    EXPECT_TRUE(std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Eigen::Vector3f& n) {
      return std::abs(n.norm() - 1.0f) < 1e-6f;
    }));
    const std::size_t count = mesh.positions.size();
    EXPECT_TRUE(std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
      return t[0] < count && t[1] < count && t[2] < count;
    }));
    EXPECT_TRUE((object.material.colour.array() >= 0.0).all() &&
                (object.material.colour.array() <= 1.0).all());
  }
}

TEST_P(EveryScene, SaysWhatToLookAtInTwoLines) {
  const Scene scene = makeScene(GetParam().name);
  EXPECT_EQ(std::count(scene.description.begin(), scene.description.end(), '\n'), 1);
  EXPECT_FALSE(scene.description.starts_with('\n') || scene.description.ends_with('\n'));
  EXPECT_EQ(scene.name, GetParam().name);
  EXPECT_EQ(scene.title, GetParam().title);
  EXPECT_EQ(scene.description, GetParam().description);
  EXPECT_EQ(scene.figure, GetParam().figure);
  EXPECT_FALSE(scene.title.empty());
}

TEST_P(EveryScene, IsSeenFromOutsideItsBodies) {
  const Scene scene = makeScene(GetParam().name);
  const Eigen::AlignedBox3d bounds = scene.lightBounds();
  EXPECT_GT(scene.camera.position.y(), 0.0);
  for (const SceneObject& object : scene.objects) {
    if (!object.boundsLight) continue;  // grounds are excluded: the line above checks their top
    EXPECT_FALSE(object.mesh.bounds().contains(scene.camera.position)) << object.name;
    EXPECT_FALSE(object.mesh.bounds().contains(scene.light.position)) << object.name;
  }
  const Eigen::Vector3d aim = scene.camera.target;
  EXPECT_TRUE(bounds.contains(aim)) << "the camera looks past the scene";
}

// The ground is solid, reaches to the horizon, and its hole is exactly as wide as the paving.
TEST_P(EveryScene, HasItsPavingSetIntoItsGround) {
  const Scene scene = makeScene(GetParam().name);
  const auto named = [&](const char* name) {
    return std::ranges::find(scene.objects, name, &SceneObject::name);
  };
  const auto paving = named("paving"), ground = named("ground");
  if (paving == scene.objects.end()) return;  // the scene has planes only
  ASSERT_NE(ground, scene.objects.end());
  EXPECT_TRUE(isClosedBody(ground->mesh));
  EXPECT_TRUE(isClosedBody(paving->mesh));
  const Eigen::AlignedBox3d set = paving->mesh.bounds(), wide = ground->mesh.bounds();
  EXPECT_LT(wide.max().y(), set.max().y());
  EXPECT_GT(wide.max().y(), set.min().y());
  // These are floats up to 64: each end is rounded by up to 2^-19.
  EXPECT_NEAR(wide.sizes().x(), 120.0, 0x1p-18);
  EXPECT_NEAR(wide.sizes().z(), 120.0, 0x1p-18);
  Eigen::AlignedBox3d hole;
  for (const Eigen::Vector3f& p : ground->mesh.positions)
    if (p.y() == float(wide.max().y()) && (p.cast<double>() - wide.center()).norm() < 20.0)
      hole.extend(p.cast<double>());
  EXPECT_EQ(hole.min().x(), set.min().x());
  EXPECT_EQ(hole.max().x(), set.max().x());
  EXPECT_EQ(hole.min().z(), set.min().z());
  EXPECT_EQ(hole.max().z(), set.max().z());
}

// Casters outside the light's frame would throw no shadow.
TEST_P(EveryScene, KeepsItsCastersInTheLightsFrame) {
  const Scene scene = makeScene(GetParam().name);
  const LightFrame frame = fitLightFrame(scene.light, scene.lightBounds());
  for (const SceneObject& object : scene.objects) {
    if (!object.boundsLight || object.name == "paving" || object.name == "ground") continue;
    for (const Eigen::Vector3f& position : object.mesh.positions)
      ASSERT_TRUE(frame.project(position.cast<double>()).inside) << object.name;
  }
}

TEST_P(EveryScene, MovesWithEachOfItsParameters) {
  for (const SceneParameter& parameter : GetParam().parameters) {
    SCOPED_TRACE(parameter.name);
    EXPECT_LT(parameter.low, parameter.high);
    EXPECT_GE(parameter.value, parameter.low);
    EXPECT_LE(parameter.value, parameter.high);
    EXPECT_FALSE(parameter.doc.empty());
    const Scene usual = makeScene(GetParam().name);
    for (double value : {parameter.low, parameter.high}) {
      if (value == parameter.value) continue;
      EXPECT_FALSE(sameObjects(usual, makeScene(GetParam().name, {{parameter.name, value}})));
    }
    EXPECT_TRUE(
        sameObjects(usual, makeScene(GetParam().name, {{parameter.name, parameter.value}})));
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryScene, testing::ValuesIn(availableScenes()),
                         [](const auto& param) {
                           std::string name = param.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(SceneCatalogue, NamesEachSceneOnce) {
  std::set<std::string> names;
  for (const SceneInfo& info : sceneCatalogue()) EXPECT_TRUE(names.insert(info.name).second);
  for (const char* name : {"three-planes", "two-planes", "spheres", "fence", "tree-bench",
                           "windmill", "car", "foliage", "teapot-arcade"})
    EXPECT_TRUE(names.contains(name)) << name;
}

// The plates lie at the depths that the parameters give, measured in the light's own depth.
TEST(SceneCatalogue, PutsThePlanesAtTheirDepths) {
  const Scene scene = makeScene("three-planes", {{"a", 0.1}, {"b", 0.5}, {"c", 0.9}});
  const LightFrame frame = fitLightFrame(scene.light, scene.lightBounds());
  const std::map<std::string, double> depths{{"A", 0.1}, {"B", 0.5}, {"C", 0.9}};
  for (const SceneObject& object : scene.objects) {
    const auto depth = depths.find(object.name);
    if (depth == depths.end()) continue;
    // Positions are floats of a few units: 2^-23 of them, over a frame of about as many.
    EXPECT_NEAR(frame.project(object.mesh.bounds().max()).z, depth->second, 4e-7) << object.name;
  }
}

TEST(SceneCatalogue, SuggestsTheNearestName) {
  expectContains(refusal([] { makeScene("three-plane"); }), "did you mean 'three-planes'?");
  expectContains(refusal([] { makeScene("zzzzzzzzzzzz"); }), "tree-bench");
}

TEST(SceneCatalogue, RefusesParametersThatItDoesNotHave) {
  const std::string unknown = refusal([] { makeScene("three-planes", {{"d", 0.5}}); });
  expectContains(unknown, "'d'");
  expectContains(unknown, "coverage");
  expectContains(refusal([] { makeScene("tree-bench", {{"a", 0.5}}); }), "none");
}

TEST(SceneCatalogue, RefusesValuesOutOfRange) {
  for (double value : {0.99, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string message = refusal([&] { makeScene("three-planes", {{"a", value}}); });
    expectContains(message, "three-planes: a:");
    expectContains(message, "from 0.02 to 0.6");
  }
}

}  // namespace
}  // namespace umbra

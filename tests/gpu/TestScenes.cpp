#include "tests/gpu/TestScenes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace umbra::test {
namespace {

void append(Mesh& mesh, const Mesh& more) {
  const auto offset = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  for (const auto& [a, b, c] : more.triangles)
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

Mesh ball(const Eigen::Vector3f& centre, float radius, int rings) {
  Mesh mesh;
  const int sectors = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= sectors; ++j) {
      const float theta = float(i) / rings * std::numbers::pi_v<float>;
      const float phi = float(j) / sectors * 2.0f * std::numbers::pi_v<float>;
      const Eigen::Vector3f normal(std::sin(theta) * std::cos(phi), std::cos(theta),
                                   -std::sin(theta) * std::sin(phi));
      mesh.normals.push_back(normal);
      mesh.positions.push_back(centre + radius * normal);
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const auto a = std::uint32_t(i * (sectors + 1) + j), b = a + sectors + 1;
      if (i > 0) mesh.triangles.push_back({a, b, a + 1});
      if (i + 1 < rings) mesh.triangles.push_back({a + 1, b, b + 1});
    }
  }
  return mesh;
}

}  // namespace

Mesh rectangle(const Eigen::Vector3f& corner, const Eigen::Vector3f& edgeA,
               const Eigen::Vector3f& edgeB) {
  Mesh mesh;
  mesh.positions = {corner, corner + edgeA, corner + edgeA + edgeB, corner + edgeB};
  mesh.normals.assign(4, edgeA.cross(edgeB).normalized());
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh box(const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  using Eigen::Vector3f;
  const Vector3f size = high - low;
  const Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  Mesh mesh;
  append(mesh, rectangle(low, x, z));
  append(mesh, rectangle(low + y, z, x));
  append(mesh, rectangle(low, z, y));
  append(mesh, rectangle(low + x, y, z));
  append(mesh, rectangle(low, y, x));
  append(mesh, rectangle(low + z, x, y));
  return mesh;
}

std::shared_ptr<Scene> slabOverGround() {
  auto scene = std::make_shared<Scene>();
  scene->name = "slab-over-ground";
  SceneObject ground, slab;
  ground.name = "ground";
  ground.mesh = rectangle({-5, 0, -5}, {0, 0, 10}, {10, 0, 0});
  slab.name = "slab";
  slab.mesh = box({1, 1, -2}, {3, 1.2f, -1});
  slab.material.colour = {0.7, 0.4, 0.2};
  scene->objects = {ground, slab};
  scene->light.position = {0, 8, 0};
  scene->light.target = {0, 0, 0};
  scene->camera.position = {0, 6, 12};
  scene->camera.target = {0, 0, 0};
  scene->camera.viewAngle = 40;
  return scene;
}

std::shared_ptr<Scene> slabAndBall() {
  auto scene = slabOverGround();
  scene->name = "slab-and-ball";
  SceneObject object;
  object.name = "ball";
  object.mesh = ball({-1.5f, 1.0f, 1.0f}, 1.0f, 24);
  object.material.physicallyBased = true;
  object.material.colour = {0.3, 0.5, 0.8};
  scene->objects.push_back(object);
  scene->light.position = {5, 8, 4};
  return scene;
}

std::shared_ptr<Scene> avenue() {
  auto scene = std::make_shared<Scene>();
  scene->name = "avenue";
  SceneObject ground, posts;
  ground.name = "ground";
  ground.mesh = rectangle({-30, 0, -60}, {0, 0, 80}, {60, 0, 0});
  posts.name = "posts";
  for (int row = 0; row < 14; ++row) {
    for (float x : {-3.0f, 0.9f, 3.3f}) {
      const float z = 13.0f - 4.6f * float(row) + 0.37f * x;
      append(posts.mesh, box({x, 0, z}, {x + 0.3f, 2.1f, z + 0.3f}));
    }
  }
  scene->objects = {ground, posts};
  scene->light.position = {14, 20, 9};
  scene->light.target = {0, 0, 0};
  scene->camera.position = {0.4, 2.6, 18.0};
  scene->camera.target = {0.2, 1.0, 8.0};
  scene->camera.viewAngle = 40.0;
  return scene;
}

}  // namespace umbra::test

// A ShadowRenderer in a headless window, and helpers to examine its results.
#pragma once

#include <string>
#include <string_view>

#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ShadowRenderer.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/TestScenes.h"

namespace umbra::test {

class FrameFixture : public GpuTest {
 protected:
  void show(const std::shared_ptr<const Scene>& scene, std::string_view id) {
    technique = allTechniques().make(id);
    renderer.reset();
    renderer.emplace(*window);
    renderer->setScene(scene);
    renderer->setLight(scene->light);
    renderer->setCamera(scene->camera);
    renderer->setFrame(settings);
    renderer->setTechnique(*technique);
    renderer->render();
  }

  void showAgain() {
    renderer->setFrame(settings);
    renderer->render();
  }

  // The passes of the last frame, in order: "depth encode prefilter shade view".
  std::string passes() const {
    std::string names;
    for (const PassTime& time : renderer->passTimes())
      names += (names.empty() ? "" : " ") + time.pass;
    return names;
  }

  // The pixel of a world point, by the camera's own mathematics.
  static Eigen::Vector2i pixelOf(const Camera& camera, const Eigen::Vector3d& world);

  void TearDown() override {
    renderer.reset();
    GpuTest::TearDown();
  }

  FrameSettings settings;
  std::unique_ptr<Technique> technique;
  std::optional<ShadowRenderer> renderer;
};

inline Eigen::Vector2i FrameFixture::pixelOf(const Camera& camera, const Eigen::Vector3d& world) {
  const Eigen::Vector3d forward = (camera.target - camera.position).normalized();
  const Eigen::Vector3d right = forward.cross(camera.up).normalized();
  const Eigen::Vector3d up = right.cross(forward);
  const Eigen::Vector3d offset = world - camera.position;
  const double scale = 0.5 * height / std::tan(0.5 * camera.viewAngle * 3.14159265358979 / 180.0);
  const double depth = offset.dot(forward);
  return {int(std::floor(0.5 * width + scale * offset.dot(right) / depth)),
          int(std::floor(0.5 * height - scale * offset.dot(up) / depth))};
}

}  // namespace umbra::test

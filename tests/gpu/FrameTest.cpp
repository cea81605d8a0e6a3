#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <cstdlib>

#include "filters/core/TechniqueCatalogue.h"
#include "filters/gpu/ShadowRenderer.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/TestScenes.h"

namespace umbra {
namespace {

// With UMBRA_TEST_PICTURES set to a folder, the pictures can be looked at.
void keep(const Image<std::uint8_t>& image, const std::string& name) {
  const char* folder = std::getenv("UMBRA_TEST_PICTURES");
  if (!folder) return;
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width(), image.height(), 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        data->SetScalarComponentFromDouble(x, image.height() - 1 - y, 0, c, image(x, y, c));
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
  writer->SetInputData(data);
  writer->Write();
}

class FrameTest : public test::GpuTest {
 protected:
  void show(const std::shared_ptr<const Scene>& scene, std::string_view technique) {
    renderer.emplace(*window);
    renderer->setScene(scene);
    renderer->setLight(scene->light);
    renderer->setCamera(scene->camera);
    renderer->setFrame(settings);
    renderer->setTechnique(*allTechniques().make(technique));
    renderer->render();
  }
  void TearDown() override {
    renderer.reset();
    GpuTest::TearDown();
  }

  FrameSettings settings;
  std::optional<ShadowRenderer> renderer;
};

TEST_F(FrameTest, DrawsASceneWithVarianceShadows) {
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    const auto scene = test::slabAndBall();
    scene->light.kind = kind;
    scene->light.halfAngle = 40;
    show(scene, "vsm");
    for (ViewMode view :
         {ViewMode::Shaded, ViewMode::Visibility, ViewMode::Error, ViewMode::Depth}) {
      settings.view = view;
      renderer->setFrame(settings);
      renderer->render();
      keep(renderer->colour(), std::string(nameOf(kind)) + "-" + std::string(nameOf(view)));
    }
    const DepthMap& map = renderer->depthMap();
    Image<std::uint8_t> depth(map.width(), map.height(), 3);
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x)
        for (int c = 0; c < 3; ++c) depth(x, y, c) = std::uint8_t(255.0 * map(x, y));
    keep(depth, std::string(nameOf(kind)) + "-map");
    settings.view = ViewMode::Shaded;
    renderer.reset();
  }
}

}  // namespace
}  // namespace umbra

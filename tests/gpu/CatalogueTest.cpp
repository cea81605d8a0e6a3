// Draws every scene of the catalogue with every technique. Where UMBRA_TEST_PICTURES names a
// folder, the pictures are saved there.
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

#include "datasets/scenes/SceneCatalogue.h"
#include "tests/gpu/FrameFixture.h"

namespace umbra {
namespace {

class CatalogueScene : public test::FrameFixture, public testing::WithParamInterface<std::string> {
 protected:
  void keepPicture(const std::string& name) {
    const char* folder = std::getenv("UMBRA_TEST_PICTURES");
    if (!folder) return;
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
    writer->Write();
  }
};

std::vector<std::string> openableScenes() {
  std::vector<std::string> names;
  for (const SceneInfo& info : sceneCatalogue())
    if (info.missing.empty()) names.push_back(info.name);
  return names;
}

TEST_P(CatalogueScene, HasLightAndShadowInEveryTechnique) {
  const auto scene = std::make_shared<const Scene>(makeScene(GetParam()));
  settings.map.size = 1024;  // at half of it the iron fence has only penumbrae
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* candidate : catalogue.all()) {
    const std::string id(candidate->info().id);
    SCOPED_TRACE(id);
    if (!renderer)
      show(scene, id);
    else
      renderer->setTechnique(*candidate);
    renderer->render();
    keepPicture(GetParam() + "-" + id);
    int lit = 0, dark = 0, surfaces = 0;
    const SurfaceImage picture = renderer->surfaces();
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        if (!picture.shows(x, y)) continue;
        ++surfaces;
        const float visibility = picture.visibility(x, y);
        ASSERT_GE(visibility, 0.0f);
        ASSERT_LE(visibility, 1.0f);
        if (visibility > 0.9f) ++lit;
        if (visibility < 0.1f) ++dark;
      }
    }
    EXPECT_GT(surfaces, width * height / 10);
    EXPECT_GT(lit, surfaces / 20);
    EXPECT_GT(dark, surfaces / 200);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, CatalogueScene, testing::ValuesIn(openableScenes()),
                         [](const testing::TestParamInfo<std::string>& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace umbra

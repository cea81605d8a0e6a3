// Cost of a frame: ours with and without baking, VTK's own shadow pass, and VTK without shadows.
#include <benchmark/benchmark.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtk_glew.h>

#include "datasets/SceneCatalogue.h"
#include "filters/core/TechniqueCatalogue.h"
#include "filters/gpu/HeadlessWindow.h"
#include "filters/gpu/ShadowRenderer.h"

namespace umbra {
namespace {

constexpr int mapSize = 1024;

// GPU milliseconds of each pass of the last frame.
void countPasses(benchmark::State& state, const ShadowRenderer& renderer) {
  for (const PassTime& time : renderer.passTimes())
    state.counters[time.pass + "_ms"] = time.milliseconds;
}

struct Stage {
  explicit Stage(const char* technique, int radius = 3)
      : window(makeHeadlessWindow(1280, 720)), renderer(*window) {
    const auto scene = std::make_shared<const Scene>(makeScene("tree-bench"));
    light = scene->light;
    // VTK's pass knows cones only.
    light.kind = LightKind::Spot;
    light.halfAngle = 40.0;
    settings.map.size = mapSize;
    settings.kernel.radius = radius;
    renderer.setScene(scene);
    renderer.setLight(light);
    renderer.setCamera(scene->camera);
    renderer.setFrame(settings);
    renderer.setTechnique(*allTechniques().make(technique));
    renderer.render();
  }

  void nudgeLight() {
    light.position.x() += 1e-3;
    renderer.setLight(light);
  }

  vtkSmartPointer<vtkRenderWindow> window;
  ShadowRenderer renderer;
  Light light;
  FrameSettings settings;
};

void cameraMoves(benchmark::State& state, const char* technique) {
  Stage stage(technique);
  for (auto _ : state) {
    stage.renderer.renderer().GetActiveCamera()->Azimuth(0.01);
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

void lightMoves(benchmark::State& state, const char* technique) {
  Stage stage(technique, int(state.range(0)));
  for (auto _ : state) {
    stage.nudgeLight();
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

void vtkAlone(benchmark::State& state, bool shadows) {
  Stage stage("vsm");
  vtkNew<vtkShadowMapBakerPass> baker;
  baker->SetResolution(mapSize);
  vtkNew<vtkShadowMapPass> shadow;
  shadow->SetShadowMapBakerPass(baker);
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkRenderPassCollection> passes;
  if (shadows) passes->AddItem(baker);
  if (shadows)
    passes->AddItem(shadow);
  else {
    passes->AddItem(lights);
    passes->AddItem(opaque);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkRenderer& renderer = stage.renderer.renderer();
  renderer.SetPass(camera);
  // Only the casting light, or VTK bakes a map for each.
  while (renderer.GetLights()->GetNumberOfItems() > 1)
    renderer.RemoveLight(vtkLight::SafeDownCast(renderer.GetLights()->GetItemAsObject(1)));
  for (auto _ : state) {
    stage.nudgeLight();
    stage.window->Render();
    glFinish();
  }
  sequence->ReleaseGraphicsResources(stage.window);
  renderer.SetPass(nullptr);
}

BENCHMARK_CAPTURE(vtkAlone, without_shadows, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(vtkAlone, shadow_map_pass, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cameraMoves, vsm, "vsm")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cameraMoves, pcf, "pcf")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lightMoves, vsm, "vsm")
    ->Arg(1)
    ->Arg(3)
    ->Arg(16)
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lightMoves, power_cdf, "power-cdf")
    ->Arg(3)
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace umbra

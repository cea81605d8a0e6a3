// Cost of a frame: ours with and without baking, VTK's own shadow pass, and VTK without shadows.
// Times are of all threads of the process, so that a busy machine hardly disturbs them. For ratios
// run everything in turns: --benchmark_enable_random_interleaving --benchmark_repetitions=5
#include <benchmark/benchmark.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/HeadlessWindow.h"
#include "filters/gpu/ShadowRenderer.h"
#include "filters/gpu/gl/OpenGL.h"

namespace umbra {
namespace {

constexpr int mapSize = 1024;

// GPU milliseconds of each pass of the last frame.
void countPasses(benchmark::State& state, const ShadowRenderer& renderer) {
  for (const PassTime& time : renderer.passTimes())
    state.counters[time.pass + "_ms"] = time.milliseconds;
}

struct Stage {
  Stage(const char* scenery, const char* technique, int radius = 3, int cascades = 1)
      : window(makeHeadlessWindow(1280, 720)), renderer(*window) {
    const auto scene = std::make_shared<const Scene>(makeScene(scenery));
    light = scene->light;
    // VTK's pass knows cones only.
    light.kind = LightKind::Spot;
    light.halfAngle = 40.0;
    settings.map.size = mapSize;
    settings.kernel.radius = radius;
    settings.map.cascades.count = cascades;
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

void cameraMoves(benchmark::State& state, const char* scenery, const char* technique) {
  Stage stage(scenery, technique);
  for (auto _ : state) {
    stage.renderer.renderer().GetActiveCamera()->Azimuth(0.01);
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

// The shading of a layered technique by the number of its layers, which a pixel must not pay for.
void cameraMovesOverLayers(benchmark::State& state, const char* technique) {
  Stage stage("tree-bench", technique);
  const std::unique_ptr<Technique> layered = allTechniques().make(technique);
  parameterNamed(layered->parameters(), "layers", technique).set(int(state.range(0)), technique);
  stage.renderer.setTechnique(*layered);
  stage.renderer.render();
  for (auto _ : state) {
    stage.renderer.renderer().GetActiveCamera()->Azimuth(0.01);
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

void filtered(benchmark::State& state, const char* technique, ReadFilter filter) {
  Stage stage("tree-bench", technique);
  stage.settings.read.filter = filter;
  stage.renderer.setFrame(stage.settings);
  for (auto _ : state) {
    stage.renderer.renderer().GetActiveCamera()->Azimuth(0.01);
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

// The levels or sums that a filter reads, beside what the light's motion bakes without it.
void filteredBake(benchmark::State& state, ReadFilter filter) {
  Stage stage("tree-bench", "vsm");
  stage.settings.read.filter = filter;
  stage.renderer.setFrame(stage.settings);
  for (auto _ : state) {
    stage.nudgeLight();
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

// Windows that stand still cost a frame only what choosing among them does; a camera that walks
// moves them and bakes all. The sun's, since a spot light's may all be the whole map.
void inCascades(benchmark::State& state, const char* scenery, int cascades, bool walks) {
  Stage stage(scenery, "vsm", 3, cascades);
  stage.light.kind = LightKind::Directional;
  stage.renderer.setLight(stage.light);
  vtkCamera* camera = stage.renderer.renderer().GetActiveCamera();
  double side = 1.0;
  for (auto _ : state) {
    if (walks) {
      const double* at = camera->GetPosition();
      camera->SetPosition(at[0] + side, at[1], at[2]);
      side = -side;
    }
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

void lightMoves(benchmark::State& state, const char* scenery, const char* technique) {
  Stage stage(scenery, technique, int(state.range(0)));
  for (auto _ : state) {
    stage.nudgeLight();
    stage.renderer.render();
    glFinish();
  }
  countPasses(state, stage.renderer);
}

// As VTK draws the scene by itself: back faces too, which only our frame culls.
void drawBackFaces(vtkRenderer& renderer) {
  vtkActorCollection* actors = renderer.GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) actor->GetProperty()->BackfaceCullingOff();
}

// With our lights, and only the casting one baked: VTK spares none but the casting light and
// lights at the camera, to which the fill light is moved; it costs the same there.
void vtkAlone(benchmark::State& state, const char* scenery, bool shadows, bool fill) {
  Stage stage(scenery, "vsm");
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
  drawBackFaces(renderer);
  vtkLight* second = vtkLight::SafeDownCast(renderer.GetLights()->GetItemAsObject(1));
  if (fill)
    second->SetLightTypeToHeadlight();
  else
    renderer.RemoveLight(second);
  for (auto _ : state) {
    stage.nudgeLight();
    stage.window->Render();
    glFinish();
  }
  sequence->ReleaseGraphicsResources(stage.window);
  renderer.SetPass(nullptr);
}

#define UMBRA_BENCHMARK(function, name, ...)     \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__) \
      ->Unit(benchmark::kMillisecond)            \
      ->MeasureProcessCPUTime()

UMBRA_BENCHMARK(vtkAlone, tree_bench_without_shadows, "tree-bench", false, true);
UMBRA_BENCHMARK(vtkAlone, tree_bench_shadow_map_pass, "tree-bench", true, true);
UMBRA_BENCHMARK(vtkAlone, tree_bench_shadow_map_pass_without_fill, "tree-bench", true, false);
UMBRA_BENCHMARK(cameraMoves, tree_bench_vsm, "tree-bench", "vsm");
UMBRA_BENCHMARK(cameraMoves, tree_bench_pcf, "tree-bench", "pcf");
UMBRA_BENCHMARK(cameraMovesOverLayers, lvsm, "lvsm")->Arg(2)->Arg(8)->Arg(16);
UMBRA_BENCHMARK(cameraMovesOverLayers, layered_power_cdf, "layered-power-cdf")->Arg(2)->Arg(8);
UMBRA_BENCHMARK(lightMoves, tree_bench_vsm, "tree-bench", "vsm")->Arg(1)->Arg(3)->Arg(16)->Arg(64);
UMBRA_BENCHMARK(lightMoves, tree_bench_power_cdf, "tree-bench", "power-cdf")->Arg(3)->Arg(64);
UMBRA_BENCHMARK(filtered, vsm_point, "vsm", ReadFilter::Point);
UMBRA_BENCHMARK(filtered, vsm_bilinear, "vsm", ReadFilter::Bilinear);
UMBRA_BENCHMARK(filtered, vsm_trilinear, "vsm", ReadFilter::Trilinear);
UMBRA_BENCHMARK(filtered, vsm_anisotropic, "vsm", ReadFilter::Anisotropic);
UMBRA_BENCHMARK(filtered, pcf_trilinear, "pcf", ReadFilter::Trilinear);
UMBRA_BENCHMARK(filteredBake, vsm_bilinear, ReadFilter::Bilinear);
UMBRA_BENCHMARK(filteredBake, vsm_trilinear, ReadFilter::Trilinear);
UMBRA_BENCHMARK(inCascades, tree_bench_one_stands, "tree-bench", 1, false);
UMBRA_BENCHMARK(inCascades, tree_bench_one_walks, "tree-bench", 1, true);
UMBRA_BENCHMARK(inCascades, tree_bench_three_stand, "tree-bench", 3, false);
UMBRA_BENCHMARK(inCascades, tree_bench_three_walk, "tree-bench", 3, true);
UMBRA_BENCHMARK(vtkAlone, three_planes_shadow_map_pass, "three-planes", true, true);
UMBRA_BENCHMARK(cameraMoves, three_planes_vsm, "three-planes", "vsm");
UMBRA_BENCHMARK(lightMoves, three_planes_vsm, "three-planes", "vsm")->Arg(3);

}  // namespace
}  // namespace umbra

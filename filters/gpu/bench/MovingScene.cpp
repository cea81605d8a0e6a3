#include "filters/gpu/bench/MovingScene.h"

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
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

#include "filters/gpu/HeadlessWindow.h"

namespace umbra {
namespace {

constexpr double lightStep = 1e-3;   // world units
constexpr double cameraStep = 0.01;  // degrees round the point that the camera looks at

// As VTK draws the scene by itself: back faces too, which only our frame culls.
void drawBackFaces(vtkRenderer& renderer) {
  vtkActorCollection* actors = renderer.GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) actor->GetProperty()->BackfaceCullingOff();
}

}  // namespace

MovingScene::MovingScene(const BenchView& view, std::optional<CostClock> clock)
    : window_(makeHeadlessWindow(view.width, view.height)),
      renderer_(*window_),
      light_(view.light),
      clock_(clock ? *clock : fittingClock()),
      meter_(clock_) {
  renderer_.setScene(view.scene);
  renderer_.setLight(light_);
  renderer_.setCamera(view.camera);
}

void MovingScene::move(Motion motion) {
  if (motion == Motion::Light) {
    light_.position.x() += side_ * lightStep;
    renderer_.setLight(light_);
  } else {
    renderer_.renderer().GetActiveCamera()->Azimuth(side_ * cameraStep);
  }
  side_ = -side_;
}

void TechniqueFrames::show(const FrameSettings& settings, const Technique& technique) {
  makeCurrent();
  followsMap_ = technique.adaptedSplitCount() > 0;
  pace_ = SplitPace::Converged;
  renderer().setSplitPace(SplitPace::Converged);
  renderer().setFrame(settings);
  renderer().setTechnique(technique);
  move(Motion::Light);
  renderer().render();
  setPace(SplitPace::Gradual);
}

// The first frame of another pace is not like those that follow.
void TechniqueFrames::setPace(SplitPace pace) {
  renderer().setSplitPace(pace);
  if (!followsMap_ || pace == pace_) return;
  pace_ = pace;
  if (pace == SplitPace::Gradual) move(Motion::Light);
  renderer().render();
}

double TechniqueFrames::draw(Motion motion) {
  makeCurrent();
  // While splits still come to rest, a camera's motion would not be all that a frame pays for.
  setPace(motion == Motion::Light ? SplitPace::Gradual : SplitPace::Converged);
  move(motion);
  return millisecondsOf([this] { renderer().render(); });
}

std::vector<PassTime> TechniqueFrames::drawPasses() {
  makeCurrent();
  setPace(SplitPace::Gradual);
  move(Motion::Light);
  renderer().setPassClock(clock() == CostClock::Gpu ? PassClock::Gpu : PassClock::Processor);
  renderer().render();
  std::vector<PassTime> times = renderer().passTimes();
  renderer().setPassClock(PassClock::Gpu);
  return times;
}

VtkFrames::VtkFrames(const BenchView& view, Baseline baseline, int mapSize,
                     std::optional<CostClock> clock)
    : MovingScene(view, clock), passes_(vtkSmartPointer<vtkSequencePass>::New()) {
  vtkNew<vtkRenderPassCollection> passes;
  if (baseline == Baseline::VtkShadowMapPass) {
    vtkNew<vtkShadowMapBakerPass> baker;
    baker->SetResolution(unsigned(mapSize));
    vtkNew<vtkShadowMapPass> shadow;
    shadow->SetShadowMapBakerPass(baker);
    passes->AddItem(baker);
    passes->AddItem(shadow);
  } else {
    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    passes->AddItem(lights);
    passes->AddItem(opaque);
  }
  passes_->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(passes_);
  vtkRenderer& scene = renderer().renderer();
  scene.SetPass(camera);
  drawBackFaces(scene);
  // VTK bakes a map for every light but those at the camera: there the dim light costs the same,
  // and only the casting one is baked.
  vtkLight::SafeDownCast(scene.GetLights()->GetItemAsObject(1))->SetLightTypeToHeadlight();
  window().Render();
}

VtkFrames::~VtkFrames() {
  makeCurrent();
  passes_->ReleaseGraphicsResources(&window());
  renderer().renderer().SetPass(nullptr);
}

double VtkFrames::draw(Motion motion) {
  makeCurrent();
  move(motion);
  return millisecondsOf([this] { window().Render(); });
}

}  // namespace umbra

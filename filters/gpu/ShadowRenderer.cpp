#include "filters/gpu/ShadowRenderer.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/LU>

#include "filters/core/support/Error.h"
#include "filters/gpu/CascadeLines.h"
#include "filters/gpu/GlErrors.h"
#include "filters/gpu/SceneActors.h"
#include "filters/gpu/VtkCamera.h"
#include "filters/gpu/vtkUmbraFramePass.h"

namespace umbra {
namespace {

// One pixel of a texture of four floats; nothing of none.
Image<float> pixelOf(const gl::Texture& picture, int x, int y) {
  if (!picture) return {};
  Image<float> pixel(1, 1, 4);
  glGetTextureSubImage(picture.name(), 0, x, y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                       GLsizei(pixel.values().size_bytes()), pixel.values().data());
  return pixel;
}

// All of it, the top row first.
Image<float> imageOf(const gl::Texture& picture) {
  if (!picture) return {};
  return gl::flipped(picture.width(), picture.height(), 4, picture.read(4));
}

}  // namespace

class ShadowRenderer::Implementation {
 public:
  explicit Implementation(vtkRenderWindow& w) : window(w), lights(*renderer) {
    renderer->SetBackground(0.93, 0.94, 0.96);
    renderer->SetPass(pass);
    lines.addTo(*renderer);
    window.AddRenderer(renderer);
  }
  ~Implementation() {
    window.MakeCurrent();
    actors.removeFrom(*renderer);
    lines.removeFrom(*renderer);
    renderer->SetPass(nullptr);
    pass->ReleaseGraphicsResources(&window);
    window.RemoveRenderer(renderer);
  }

  void updateLight() {
    lights.setLight(light);
    if (!scene) return;
    const Eigen::AlignedBox3d bounds = scene->lightBounds();
    pass->SetLightFrame(fitLightFrame(light, bounds), bounds);
  }

  // A frozen view is seen from elsewhere, with its own splits.
  void updateLines() {
    const CascadeSettings& cascades = pass->GetSettings().map.cascades;
    if (scene && cascades.frozen && cascades.count > 1)
      lines.show(*cascades.frozen, renderer->GetTiledAspectRatio(), pass->FitCascades(renderer));
    else
      lines.hide();
  }

  // Every read-back calls it: it throws when there is nothing to read.
  void requireFrame() {
    if (!pass->HasFrame())
      throw Error(ErrorKind::WorkFailed, "no frame has been rendered that could be read back");
    window.MakeCurrent();
  }

  // Whether the last frames of both have the same depth maps, texel for texel.
  bool hasMapsOf(const Implementation& other) const {
    return drawnScene == other.drawnScene && pass->HasMapsOf(*other.pass);
  }

  // World position of pixel (x, y), y up, at camera depth [0,1].
  Eigen::Vector3d unproject(int x, int y, double depth) const {
    int width = 0, height = 0, left = 0, bottom = 0;
    renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
    const vtkMatrix4x4* m = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        renderer->GetTiledAspectRatio(), -1.0, 1.0);
    Eigen::Matrix4d worldToClip;
    for (int i = 0; i < 16; ++i) worldToClip(i / 4, i % 4) = m->GetElement(i / 4, i % 4);
    const Eigen::Vector4d clip(2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0,
                               2.0 * depth - 1.0, 1.0);
    return (worldToClip.inverse() * clip).hnormalized();
  }

  vtkRenderWindow& window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkUmbraFramePass> pass;
  SceneActors actors;
  SceneLights lights;
  CascadeLines lines;
  std::shared_ptr<const Scene> scene;
  Light light;
  std::shared_ptr<const Scene> drawnScene;  // in the last frame
  Camera drawnCamera;
  std::shared_ptr<const FrameSnapshot> snapshot;  // of the last frame, once asked for
};

ShadowRenderer::ShadowRenderer(vtkRenderWindow& window)
    : implementation_(std::make_unique<Implementation>(window)) {}

ShadowRenderer::~ShadowRenderer() = default;

void ShadowRenderer::setScene(std::shared_ptr<const Scene> scene) {
  Implementation& my = *implementation_;
  if (!scene || scene->triangleCount() == 0)
    throw Error(ErrorKind::BadInput, "scene: there is no triangle to draw");
  // The actors of the last scene free their buffers.
  my.window.MakeCurrent();
  my.actors.setScene(*scene, *my.renderer);
  my.pass->SetScene(my.actors);
  my.scene = std::move(scene);
  my.updateLight();
}

void ShadowRenderer::setLight(const Light& light) {
  implementation_->light = light;
  implementation_->updateLight();
}

void ShadowRenderer::setCamera(const Camera& camera) {
  vtkCamera* vtk = implementation_->renderer->GetActiveCamera();
  vtk->SetPosition(camera.position.x(), camera.position.y(), camera.position.z());
  vtk->SetFocalPoint(camera.target.x(), camera.target.y(), camera.target.z());
  vtk->SetViewUp(camera.up.x(), camera.up.y(), camera.up.z());
  vtk->SetViewAngle(camera.viewAngle);
}

void ShadowRenderer::setFrame(const FrameSettings& settings) {
  implementation_->pass->SetSettings(settings);
}

void ShadowRenderer::setTechnique(const Technique& technique) {
  implementation_->pass->SetTechnique(technique);
}

void ShadowRenderer::setSplitPace(SplitPace pace) {
  implementation_->pass->SetSplitPace(pace);
}

bool ShadowRenderer::splitsMoving() const {
  return implementation_->pass->SplitsMoving();
}

std::vector<double> ShadowRenderer::adaptedSplits() const {
  return implementation_->pass->GetAdaptedSplits();
}

Camera ShadowRenderer::camera() const {
  return cameraOf(*implementation_->renderer->GetActiveCamera());
}

vtkRenderer& ShadowRenderer::renderer() {
  return *implementation_->renderer;
}

LightFrame ShadowRenderer::lightFrame() const {
  return implementation_->pass->GetLightFrame();
}

void ShadowRenderer::render() {
  Implementation& my = *implementation_;
  const VtkErrors errors;
  my.snapshot.reset();
  my.updateLines();
  my.renderer->ResetCameraClippingRange();
  my.window.Render();
  my.pass->RethrowError();
  my.drawnScene = my.scene;
  my.drawnCamera = camera();
  if (!errors.messages().empty())
    throw Error(ErrorKind::WorkFailed, "VTK: " + errors.messages().front());
}

Image<std::uint8_t> ShadowRenderer::colour() {
  Implementation& my = *implementation_;
  my.requireFrame();
  const int* size = my.window.GetSize();
  const int width = size[0], height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  my.window.GetPixelData(0, 0, width - 1, height - 1, 1, pixels);
  Image<std::uint8_t> image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image(x, y, c) = pixels->GetTypedComponent(vtkIdType(height - 1 - y) * width + x, c);
  return image;
}

SurfaceImage ShadowRenderer::surfaces() {
  implementation_->requireFrame();
  const vtkUmbraShadingPass& shading = implementation_->pass->GetShading();
  return {imageOf(shading.GetSurfaces()), imageOf(shading.GetFootprints())};
}

std::shared_ptr<const FrameSnapshot> ShadowRenderer::snapshot(ShadowRenderer* beside) {
  Implementation& my = *implementation_;
  my.requireFrame();
  if (my.snapshot) return my.snapshot;
  const bool shared = beside && my.hasMapsOf(*beside->implementation_);
  ShadowRenderer& mapped = shared ? *beside : *this;
  const auto snapshot = std::make_shared<FrameSnapshot>();
  snapshot->scene = my.drawnScene;
  snapshot->camera = my.drawnCamera;
  snapshot->settings = my.pass->GetDrawnSettings();
  snapshot->light = lightFrame();
  snapshot->cascades = cascades();
  for (int i = 0; i < int(snapshot->cascades.size()); ++i)
    snapshot->maps.push_back(mapped.sharedDepthMap(i));
  my.window.MakeCurrent();
  snapshot->surfaces = surfaces();
  snapshot->technique = my.pass->GetDrawnTechnique();
  return my.snapshot = snapshot;
}

std::optional<SurfacePoint> ShadowRenderer::surfaceAt(int x, int y) {
  Implementation& my = *implementation_;
  my.requireFrame();
  const vtkUmbraShadingPass& shading = my.pass->GetShading();
  const gl::Texture& surfaces = shading.GetSurfaces();
  if (x < 0 || y < 0 || x >= surfaces.width() || y >= surfaces.height()) return {};
  const int row = surfaces.height() - 1 - y;
  const SurfaceImage pixel(pixelOf(surfaces, x, row), pixelOf(shading.GetFootprints(), x, row));
  std::optional<SurfacePoint> point = pixel.at(0, 0);
  if (!point) return {};
  float depth = 1.0f;
  glGetTextureSubImage(shading.GetDepth().name(), 0, x, row, 0, 1, 1, 1, GL_DEPTH_COMPONENT,
                       GL_FLOAT, sizeof depth, &depth);
  point->world = my.unproject(x, row, depth);
  return point;
}

Image<float> ShadowRenderer::reference() {
  implementation_->requireFrame();
  const gl::Texture& texture = implementation_->pass->GetShading().GetSurfaces();
  const std::vector<float> both = implementation_->pass->EvaluateSurfaces();
  std::vector<float> reference(both.size() / 2);
  for (std::size_t i = 0; i < reference.size(); ++i) reference[i] = both[2 * i + 1];
  return gl::flipped(texture.width(), texture.height(), 1, reference);
}

const std::vector<Cascade>& ShadowRenderer::cascades() const {
  return implementation_->pass->GetCascades();
}

Baked ShadowRenderer::baked() const {
  return implementation_->pass->GetBaked();
}

int ShadowRenderer::samples() const {
  return implementation_->pass->GetBaker().samples();
}

std::shared_ptr<const DepthMap> ShadowRenderer::sharedDepthMap(int cascade) {
  implementation_->requireFrame();
  return implementation_->pass->GetDepthMap(cascade);
}

Image<float> ShadowRenderer::channels(BakeStage stage, int cascade) {
  implementation_->requireFrame();
  return implementation_->pass->GetBaker().read(stage, cascade);
}

void ShadowRenderer::setPassClock(PassClock clock) {
  implementation_->pass->SetPassClock(clock);
}

void ShadowRenderer::forgetBake() {
  implementation_->pass->ForgetBake();
}

std::vector<PassTime> ShadowRenderer::passTimes() const {
  implementation_->window.MakeCurrent();
  std::vector<PassTime> times;
  for (const gl::PassTimer::Time& time : implementation_->pass->GetTimer().times())
    times.push_back({time.pass, time.milliseconds});
  return times;
}

}  // namespace umbra

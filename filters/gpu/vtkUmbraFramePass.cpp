#include "filters/gpu/vtkUmbraFramePass.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDefaultPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "FullScreen_vert_glsl.h"
#include "Surface_glsl.h"
#include "View_frag_glsl.h"
#include "filters/core/settings/SettingsTable.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"
#include "filters/core/technique/TechniqueEquality.h"
#include "filters/gpu/SceneActors.h"
#include "filters/gpu/TechniqueShader.h"
#include "filters/gpu/ViewColours.h"
#include "filters/gpu/VtkCamera.h"
#include "filters/gpu/gl/OpenGL.h"

namespace umbra {
namespace {

vtkOpenGLRenderWindow* windowOf(vtkRenderer* renderer) {
  return static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
}

// The number by which View.frag.glsl knows it. A technique without layers has nothing to tint.
int viewNumber(ViewMode view, const Technique& technique) {
  switch (view) {
    case ViewMode::Shaded:
      return 0;
    case ViewMode::Layers:
      return technique.info().layered() ? 4 : 0;
    case ViewMode::Visibility:
      return 1;
    case ViewMode::Error:
      return 2;
    case ViewMode::Depth:
      return 3;
    case ViewMode::Cascades:
      return 5;
  }
  return 0;
}

// A summed-area table averages the kernel's box by itself, so nothing is prefiltered.
Kernel blurOf(const FrameSettings& settings) {
  const bool summed = settings.read.filter == ReadFilter::SummedArea;
  return summed ? Kernel{KernelShape::None, 0} : settings.kernel;
}

}  // namespace

vtkStandardNewMacro(vtkUmbraFramePass);

vtkUmbraFramePass::vtkUmbraFramePass()
    : Depth(vtkSmartPointer<vtkUmbraDepthPass>::New()),
      Shading(vtkSmartPointer<vtkUmbraShadingPass>::New()),
      Others(vtkSmartPointer<vtkDefaultPass>::New()) {}

vtkUmbraFramePass::~vtkUmbraFramePass() = default;

void vtkUmbraFramePass::SetScene(const SceneActors& actors) {
  this->SceneProps.clear();
  for (const auto& actor : actors.objects()) this->SceneProps.insert(actor);
  this->ClosedBodies = actors.closedBodies();
  this->Caster = actors.caster();
  this->MakeStale(Stage::Depth);
}

void vtkUmbraFramePass::SetLightFrame(const LightFrame& frame, const Eigen::AlignedBox3d& bounds) {
  // Whether depths have to be drawn again shows when the cascades have been fitted.
  this->Frame = frame;
  this->Bounds = bounds;
  this->HasLightFrame = true;
}

void vtkUmbraFramePass::SetSettings(const FrameSettings& settings) {
  // What else the bake depends on, the cascades' windows, shows when they have been fitted.
  FrameSettings before = this->Settings;
  before.map.cascades = settings.map.cascades;
  this->MakeStale(firstStaleStage(before, settings));
  this->Settings = settings;
}

void vtkUmbraFramePass::SetTechnique(const Technique& technique) {
  if (this->Asked && sameSettings(*this->Asked, technique)) return;
  this->Asked = technique.clone();
  this->MakeStale(Stage::Encode);
}

void vtkUmbraFramePass::Render(const vtkRenderState* state) {
  this->NumberOfRenderedProps = 0;
  this->FrameDrawn = false;
  try {
    this->DrawFrame(state);
  } catch (...) {
    // VTK's frames on the stack expect no exception.
    this->Error = std::current_exception();
  }
}

void vtkUmbraFramePass::DrawFrame(const vtkRenderState* state) {
  if (!gl::hasVersion45())
    throw umbra::Error(ErrorKind::NoOpenGL,
                       "the window's OpenGL is older than the 4.5 that shadows need; a newer "
                       "driver, or Debian's libgl1-mesa-dri, brings it");
  vtkRenderer* renderer = state->GetRenderer();
  std::vector<vtkProp*> own, others;
  for (int i = 0; i < state->GetPropArrayCount(); ++i) {
    vtkProp* prop = state->GetPropArray()[i];
    (this->SceneProps.count(prop) ? own : others).push_back(prop);
  }
  this->Timer.startFrame();
  const bool complete = this->Caster && this->Asked && this->HasLightFrame;
  if (complete) {
    this->FitCascades(renderer);
    this->Bake(state);
  }

  this->ClearLights(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateCamera(renderer);  // clears the window as well
  if (complete) {
    vtkRenderState scene(renderer);
    scene.SetPropArrayAndCount(own.data(), int(own.size()));
    this->CullInsides(renderer);
    this->Shading->SetTechnique(this->Adapted.get());
    const bool summed = this->Settings.read.filter == ReadFilter::SummedArea;
    this->Shading->SetMaps(&this->Baker.depthMap(), &this->Baker.channelMap(),
                           summed ? &this->Baker.sumMap() : &this->Baker.levelMap());
    this->Shading->SetReads(this->Reads());
    this->Shading->SetCascades(this->Cascades);
    this->Shading->SetLightFrame(this->Frame);
    this->Shading->SetSettings(this->SettledSettings());
    {
      const gl::PassTimer::Scope time(this->Timer, "shade");
      this->Shading->Render(&scene);
    }
    this->NumberOfRenderedProps += this->Shading->GetNumberOfRenderedProps();
    const gl::PassTimer::Scope time(this->Timer, "view");
    this->Show(renderer);
    this->DrawnReads = this->Reads();
    this->DrawnSettings = this->Settings;
    this->FrameDrawn = true;
  }
  vtkRenderState rest(renderer);
  rest.SetPropArrayAndCount(others.data(), int(others.size()));
  this->Others->Render(&rest);
  this->NumberOfRenderedProps += this->Others->GetNumberOfRenderedProps();
}

const std::vector<Cascade>& vtkUmbraFramePass::FitCascades(vtkRenderer* renderer) {
  if (!this->HasLightFrame) return this->Cascades;
  const MapSettings& map = this->Settings.map;
  const Camera camera = map.cascades.frozen.value_or(cameraOf(*renderer->GetActiveCamera()));
  // A summed-area table's box may reach farther than the kernel: it repeats the window's edge
  // there.
  this->Cascades = fitCascades(this->Frame, camera, renderer->GetTiledAspectRatio(), this->Bounds,
                               map, this->Settings.kernel.effectiveRadius());
  return this->Cascades;
}

// Fills in the distances that the settings leave to the scene.
FrameSettings vtkUmbraFramePass::SettledSettings() const {
  FrameSettings settled = this->Settings;
  if (settled.read.satDistance == 0.0) settled.read.satDistance = this->Bounds.diagonal().norm();
  return settled;
}

void vtkUmbraFramePass::Bake(const vtkRenderState* state) {
  const std::string reason = whyImpossible(this->Settings, *this->Asked);
  if (!reason.empty()) throw umbra::Error(ErrorKind::WorkFailed, reason);
  this->BakeDepth(state);
  const ReadSettings& read = this->Settings.read;
  const bool sums = read.filter == ReadFilter::SummedArea;
  const auto needsMore = [&] {
    return (readsLevels(read.filter) && this->Baker.needsLevels()) ||
           (sums && this->Baker.needsSums(read.satPrecision));
  };
  const int splits = this->Asked->adaptedSplitCount();
  const bool relaxing = splits > 0 && this->Relaxer.due(splits, this->Pace);
  if (this->Stale > Stage::Prefilter && !relaxing && !needsMore()) return;
  // VTK remembers which program it bound last; the baker binds others.
  windowOf(state->GetRenderer())->GetShaderCache()->ReleaseCurrentShader();
  if (relaxing) this->RelaxSplits();
  if (this->Stale <= Stage::Encode) {
    this->Adapted = this->Asked->clone();
    if (splits > 0) this->Adapted->setAdaptedSplits(this->Relaxer.splits());
    this->Adapted->limitTo(this->Settings.map.format);
    const gl::PassTimer::Scope time(this->Timer, "encode");
    this->Baker.encode(*this->Adapted, this->Settings.map.format);
  }
  if (this->Stale <= Stage::Prefilter) {
    this->Made.channels = std::make_shared<int>();
    const gl::PassTimer::Scope time(this->Timer, "prefilter");
    this->Baker.prefilter(blurOf(this->Settings));
  }
  this->Stale = Stage::Nothing;
  if (needsMore()) {
    const gl::PassTimer::Scope time(this->Timer, sums ? "sums" : "levels");
    sums ? this->Baker.buildSums(read.satPrecision) : this->Baker.buildLevels();
  }
}

void vtkUmbraFramePass::RelaxSplits() {
  const gl::PassTimer::Scope time(this->Timer, "splits");
  const int count = this->Asked->adaptedSplitCount();
  if (this->Relaxer.advance(this->Baker.depthMap(), count, this->Pace))
    this->MakeStale(Stage::Encode);
}

std::vector<double> vtkUmbraFramePass::GetAdaptedSplits() const {
  if (!this->Asked || this->Asked->adaptedSplitCount() == 0) return {};
  return this->Relaxer.splits();
}

// Draws the cascades whose windows have changed since they were drawn.
void vtkUmbraFramePass::BakeDepth(const vtkRenderState* state) {
  const std::size_t count = this->Cascades.size();
  if (this->Stale == Stage::Depth || this->Drawn.size() != count) {
    this->Drawn.clear();
    this->DepthValues.assign(count, nullptr);
    const int size = this->Settings.map.size;
    const int samples = vtkUmbraDepthPass::SamplesGiven(this->Settings.map.samples);
    this->Baker.prepareDepth(size, size, int(count), samples);
  }
  std::vector<std::size_t> stale;
  for (std::size_t i = 0; i < count; ++i)
    if (i >= this->Drawn.size() || !drawSameDepths(this->Drawn[i], this->Cascades[i].frame))
      stale.push_back(i);
  if (stale.empty()) return;
  const gl::PassTimer::Scope time(this->Timer, "depth");
  this->Drawn.resize(count);
  this->Made.maps = std::make_shared<int>();
  if (stale.front() == 0) this->Made.firstMap = std::make_shared<int>();
  for (std::size_t i : stale) this->DrawDepth(state, i);
  this->MakeStale(Stage::Encode);
}

void vtkUmbraFramePass::DrawDepth(const vtkRenderState* state, std::size_t cascade) {
  this->DepthValues[cascade].reset();
  if (cascade == 0) this->Relaxer.mapChanged();
  this->Drawn[cascade] = this->Cascades[cascade].frame;
  // The frame's y is turned round and the winding with it: culling what OpenGL takes for back
  // faces removes the faces towards the light.
  this->Caster->GetProperty()->SetBackfaceCulling(this->Settings.bias.cullFrontFaces);
  this->Depth->SetCaster(this->Caster);
  this->Depth->SetLightFrame(this->Drawn[cascade]);
  this->Depth->SetSamples(this->Baker.samples());
  this->Depth->SetTarget(&this->Baker.depthMap(), int(cascade) * this->Baker.samples());
  this->Depth->Render(state);
}

void vtkUmbraFramePass::CullInsides(vtkRenderer* renderer) {
  vtkCamera* camera = renderer->GetActiveCamera();
  for (const auto& body : this->ClosedBodies) {
    // From within, and where the near plane may cut a body open, its inside must be seen.
    vtkBoundingBox bounds(body->GetBounds());
    bounds.Inflate(2.0 * camera->GetClippingRange()[0]);
    body->GetProperty()->SetBackfaceCulling(!bounds.ContainsPoint(camera->GetPosition()));
  }
}

// Copies picture and depth unchanged, where the window's buffers are of the same kind.
bool vtkUmbraFramePass::CopyShaded(vtkRenderer* renderer) {
  if (viewNumber(this->Settings.view, *this->Adapted) != 0 || renderer->GetGradientBackground())
    return false;
  GLint target = 0, samples = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetNamedFramebufferParameteriv(GLuint(target), GL_SAMPLES, &samples);
  if (samples != 0 || gl::depthFormatOf(GLuint(target)) != this->Shading->GetDepth().format())
    return false;
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  glBlitNamedFramebuffer(this->Shading->GetFramebuffer(), GLuint(target), 0, 0, width, height, left,
                         bottom, left + width, bottom + height,
                         GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return true;
}

void vtkUmbraFramePass::Show(vtkRenderer* renderer) {
  if (this->CopyShaded(renderer)) return;
  vtkOpenGLState* gl = windowOf(renderer)->GetState();
  windowOf(renderer)->GetShaderCache()->ReleaseCurrentShader();
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(gl);
  const vtkOpenGLState::ScopedglEnableDisable blend(gl, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(gl, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable cull(gl, GL_CULL_FACE);
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglDisable(GL_CULL_FACE);
  gl->vtkglEnable(GL_DEPTH_TEST);  // without the test nothing is written to the depth buffer
  gl->vtkglDepthFunc(GL_ALWAYS);
  gl->vtkglDepthMask(GL_TRUE);

  const std::string fragment = "#version 430\n#define UMBRA_VIEW " +
                               std::to_string(viewNumber(this->Settings.view, *this->Adapted)) +
                               "\n" + techniqueSource(*this->Adapted, this->Reads()) +
                               Surface_glsl + View_frag_glsl;
  const GLuint program = this->Programs.screen("view", FullScreen_vert_glsl, fragment);
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const std::pair<const char*, GLuint> textures[] = {
      {"umbraDepthMap", this->Baker.depthMap().name()},
      {"umbraColour", this->Shading->GetColour().name()},
      {"umbraSurfaces", this->Shading->GetSurfaces().name()},
      {"umbraDepth", this->Shading->GetDepth().name()},
      {"umbraFootprints", this->Shading->GetFootprints().name()}};
  for (int unit = 0; unit < int(std::size(textures)); ++unit) {
    gl::setUniform(program, textures[unit].first, unit);
    glBindTextureUnit(GLuint(unit), textures[unit].second);
  }
  gl::setUniform3(program, "umbraNoErrorColour", noErrorColour);
  gl::setUniform3(program, "umbraBleedingColour", bleedingColour);
  gl::setUniform3(program, "umbraDarkeningColour", darkeningColour);
  gl::setUniform(program, "umbraFullError", float(this->Settings.errorRange));
  gl::setUniform(program, "umbraOrigin", left, bottom);
  gl::setUniform3(program, "umbraLayerColours", {layerColours[0].data(), 3 * layerColours.size()});
  gl::setUniform3(program, "umbraCascadeColours",
                  {cascadeColours[0].data(), 3 * cascadeColours.size()});
  setReadUniforms(program, this->Reads());
  setTechniqueUniforms(program, *this->Adapted, this->Settings.map.format);

  if (!this->NoVertices) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    this->NoVertices = gl::VertexArrayHandle(name);
  }
  glUseProgram(program);
  glBindVertexArray(this->NoVertices.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
}

std::shared_ptr<const DepthMap> vtkUmbraFramePass::GetDepthMap(int cascade) {
  std::shared_ptr<const DepthMap>& map = this->DepthValues.at(std::size_t(cascade));
  if (!map) map = std::make_shared<const DepthMap>(this->Baker.readDepth(cascade));
  return map;
}

bool vtkUmbraFramePass::HasMapsOf(const vtkUmbraFramePass& other) const {
  if (!this->HasFrame() || !other.HasFrame()) return false;
  // Cascades are told apart by the frames that they were drawn from.
  FrameSettings settings = this->DrawnSettings;
  settings.map.cascades = other.DrawnSettings.map.cascades;
  return firstStaleStage(settings, other.DrawnSettings) != Stage::Depth &&
         this->Baker.samples() == other.Baker.samples() &&
         std::equal(this->Drawn.begin(), this->Drawn.end(), other.Drawn.begin(), other.Drawn.end(),
                    drawSameDepths);
}

MapReads vtkUmbraFramePass::Reads() const {
  MapReads reads;
  reads.kernel = this->Settings.kernel;
  reads.filter = this->Settings.read.filter;
  reads.samples = this->Baker.samples();
  reads.cascades = this->Baker.cascades();
  reads.satPrecision = this->Settings.read.satPrecision;
  for (std::size_t i = 0; i < this->Cascades.size(); ++i) {
    const Cascade& cascade = this->Cascades[i];
    reads.windows[i] = Eigen::Vector3d(cascade.left, cascade.top, cascade.side).cast<float>();
  }
  return reads;
}

std::vector<float> vtkUmbraFramePass::EvaluateSurfaces() {
  return this->Baker.evaluate(this->Shading->GetSurfaces(), &this->Shading->GetFootprints(),
                              *this->Adapted, this->DrawnReads);
}

void vtkUmbraFramePass::ReleaseGraphicsResources(vtkWindow* window) {
  this->Depth->ReleaseGraphicsResources(window);
  this->Shading->ReleaseGraphicsResources(window);
  this->Others->ReleaseGraphicsResources(window);
  if (this->Caster) this->Caster->ReleaseGraphicsResources(window);
  this->Baker.releaseGraphicsResources();
  this->Relaxer.releaseGraphicsResources();
  this->Programs.clear();
  this->NoVertices.reset();
  this->Timer.clear();
  this->FrameDrawn = false;
  this->Stale = Stage::Depth;
}

}  // namespace umbra

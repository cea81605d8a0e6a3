// The whole frame: bakes what is stale, shades the scene, shows the asked view of it, and draws
// everybody else's props over it.
#pragma once

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include <exception>
#include <memory>
#include <optional>
#include <unordered_set>

#include "filters/core/maps/Cascades.h"
#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/ChannelBaker.h"
#include "filters/gpu/SplitRelaxer.h"
#include "filters/gpu/gl/PassTimer.h"
#include "filters/gpu/vtkUmbraDepthPass.h"
#include "filters/gpu/vtkUmbraShadingPass.h"

class vtkActor;
class vtkDefaultPass;

namespace umbra {

class SceneActors;

class vtkUmbraFramePass : public vtkRenderPass {
 public:
  static vtkUmbraFramePass* New();
  vtkTypeMacro(vtkUmbraFramePass, vtkRenderPass);

  // Each makes stale what depends on it and no more.
  void SetScene(const SceneActors& actors);
  // The frame is fitted to `bounds` (world): the view of them is what cascades split.
  void SetLightFrame(const LightFrame& frame, const Eigen::AlignedBox3d& bounds);
  void SetSettings(const FrameSettings& settings);
  void SetTechnique(const Technique& technique);

  // How splits that follow the map come to rest: converged unless it is set.
  void SetSplitPace(SplitPace pace) { this->Pace = pace; }
  // Whether another frame would move them.
  bool SplitsMoving() const;
  // Ascending, of the last frame; none where the technique's do not follow the map.
  std::vector<double> GetAdaptedSplits() const;

  // Never throws: an error ends the frame and waits for RethrowError.
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void RethrowError();

  ChannelBaker& GetBaker() { return this->Baker; }
  const vtkUmbraShadingPass& GetShading() const { return *this->Shading; }
  const gl::PassTimer& GetTimer() const { return this->Timer; }
  const LightFrame& GetLightFrame() const { return this->Frame; }
  // Whether a frame was drawn whose maps and pictures still exist.
  bool HasFrame() const { return this->FrameDrawn; }
  // Fits the cascades to the renderer's camera as it is now, or to the frozen one; each frame does
  // it by itself.
  const std::vector<Cascade>& FitCascades(vtkRenderer* renderer);
  const std::vector<Cascade>& GetCascades() const { return this->Cascades; }
  const FrameSettings& GetSettings() const { return this->Settings; }
  const DepthMap& GetDepthMap(int cascade = 0);
  // Two floats a pixel, bottom row first: visibility and reference.
  std::vector<float> EvaluateSurfaces();

 protected:
  vtkUmbraFramePass();
  ~vtkUmbraFramePass() override;

 private:
  // What has to be done again, with everything after it.
  enum class Stage { Depth, Encode, Prefilter, Nothing };
  void MakeStale(Stage stage) { this->Stale = std::min(this->Stale, stage); }

  void DrawFrame(const vtkRenderState* state);
  void Bake(const vtkRenderState* state);
  void BakeDepth(const vtkRenderState* state);
  void RelaxSplits();
  void DrawDepth(const vtkRenderState* state, std::size_t cascade);
  FrameSettings SettledSettings() const;
  MapReads Reads() const;  // of the maps as they are baked
  void CullInsides(vtkRenderer* renderer);
  void Show(vtkRenderer* renderer);
  bool CopyShaded(vtkRenderer* renderer);

  vtkSmartPointer<vtkUmbraDepthPass> Depth;
  vtkSmartPointer<vtkUmbraShadingPass> Shading;
  vtkSmartPointer<vtkDefaultPass> Others;  // draws the props that are not the scene's
  ChannelBaker Baker;
  SplitRelaxer Relaxer;  // of the first cascade's map
  SplitPace Pace = SplitPace::Converged;
  gl::ProgramCache Programs;
  gl::VertexArrayHandle NoVertices;
  gl::PassTimer Timer;

  std::unordered_set<const vtkProp*> SceneProps;
  std::vector<vtkSmartPointer<vtkActor>> ClosedBodies;
  vtkSmartPointer<vtkActor> Caster;
  LightFrame Frame;
  Eigen::AlignedBox3d Bounds;
  bool HasLightFrame = false;
  std::vector<Cascade> Cascades;
  std::vector<LightFrame> Drawn;  // what each cascade's depths were drawn from
  FrameSettings Settings;
  std::unique_ptr<Technique> Asked;    // as it was set
  std::unique_ptr<Technique> Adapted;  // to the depth map and the format
  Stage Stale = Stage::Depth;
  std::vector<std::optional<DepthMap>> DepthValues;  // of each cascade, read back once per bake
  bool FrameDrawn = false;
  MapReads DrawnReads;  // of that frame
  std::exception_ptr Error;
};

}  // namespace umbra

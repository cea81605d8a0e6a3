// The whole frame: it bakes what is stale, shades the scene, shows the view mode that is set, and
// draws all other props over it.
#pragma once

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include <exception>
#include <memory>
#include <optional>
#include <unordered_set>
#include <utility>

#include "filters/core/maps/Cascades.h"
#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/settings/Stage.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/Baked.h"
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

  // Each of these makes stale what depends on it, and no more.
  void SetScene(const SceneActors& actors);
  // The frame is fitted to `bounds` (world); cascades split the view of these bounds.
  void SetLightFrame(const LightFrame& frame, const Eigen::AlignedBox3d& bounds);
  void SetSettings(const FrameSettings& settings);
  void SetTechnique(const Technique& technique);

  // Sets how splits that follow the map come to rest. The default is Converged.
  void SetSplitPace(SplitPace pace) { this->Pace = pace; }
  // Whether another frame would move splits.
  bool SplitsMoving() const {
    return this->Asked && this->Asked->adaptedSplitCount() > 0 && this->Relaxer.moving();
  }
  // The last frame's splits, ascending; empty where the technique's do not follow the map.
  std::vector<double> GetAdaptedSplits() const;

  // It never throws: an error ends the frame and waits for RethrowError.
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void RethrowError() {
    if (this->Error) std::rethrow_exception(std::exchange(this->Error, nullptr));
  }

  ChannelBaker& GetBaker() { return this->Baker; }
  const vtkUmbraShadingPass& GetShading() const { return *this->Shading; }
  // As the last frame left it.
  const Baked& GetBaked() const { return this->Made; }
  const gl::PassTimer& GetTimer() const { return this->Timer; }
  void SetPassClock(PassClock clock) { this->Timer.setClock(clock); }
  void ForgetBake() { this->MakeStale(Stage::Depth); }
  const LightFrame& GetLightFrame() const { return this->Frame; }
  // Whether a frame was drawn whose maps and pictures still exist.
  bool HasFrame() const { return this->FrameDrawn; }
  // Fits the cascades to the renderer's camera as it is now, or to the frozen one. Each frame does
  // so by itself.
  const std::vector<Cascade>& FitCascades(vtkRenderer* renderer);
  const std::vector<Cascade>& GetCascades() const { return this->Cascades; }
  const FrameSettings& GetSettings() const { return this->Settings; }
  // These two describe the last frame; HasFrame() says whether there is one.
  const FrameSettings& GetDrawnSettings() const { return this->DrawnSettings; }
  std::shared_ptr<const Technique> GetDrawnTechnique() const { return this->Adapted->clone(); }
  // Whether the last frames of both have depth maps that were drawn alike, if they drew one scene.
  bool HasMapsOf(const vtkUmbraFramePass& other) const;
  // Read back once per bake: equal pointers mean that nothing was drawn anew between them.
  std::shared_ptr<const DepthMap> GetDepthMap(int cascade = 0);
  // Two floats a pixel, bottom row first: visibility and reference.
  std::vector<float> EvaluateSurfaces();

 protected:
  vtkUmbraFramePass();
  ~vtkUmbraFramePass() override;

 private:
  // The stage has to be done again, with every stage after it.
  void MakeStale(Stage stage) { this->Stale = std::min(this->Stale, stage); }

  void DrawFrame(const vtkRenderState* state);
  void Bake(const vtkRenderState* state);
  void BakeDepth(const vtkRenderState* state);
  void RelaxSplits();
  void DrawDepth(const vtkRenderState* state, std::size_t cascade);
  FrameSettings SettledSettings() const;
  MapReads Reads() const;  // reads of the maps as they are baked
  void CullInsides(vtkRenderer* renderer);
  void Show(vtkRenderer* renderer);
  bool CopyShaded(vtkRenderer* renderer);

  vtkSmartPointer<vtkUmbraDepthPass> Depth;
  vtkSmartPointer<vtkUmbraShadingPass> Shading;
  vtkSmartPointer<vtkDefaultPass> Others;  // draws the props that are not the scene's
  ChannelBaker Baker;
  SplitRelaxer Relaxer;  // works on the first cascade's map
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
  std::vector<LightFrame> Drawn;  // the frame from which each cascade's depths were drawn
  FrameSettings Settings;
  std::unique_ptr<Technique> Asked;    // as it was set
  std::unique_ptr<Technique> Adapted;  // to the depth map and the format
  Stage Stale = Stage::Depth;          // later than Prefilter: nothing that is baked
  Baked Made;
  // One for each cascade, once it has been asked for in this bake.
  std::vector<std::shared_ptr<const DepthMap>> DepthValues;
  bool FrameDrawn = false;
  MapReads DrawnReads;  // the reads of the last frame
  FrameSettings DrawnSettings;
  std::exception_ptr Error;
};

}  // namespace umbra

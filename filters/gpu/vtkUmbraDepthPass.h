// Draws what casts shadows from the light, depth only.
#pragma once

#include <vtkOpenGLRenderPass.h>

#include "filters/core/scene/Light.h"
#include "filters/gpu/gl/MultisampleTexture.h"
#include "filters/gpu/gl/Program.h"
#include "filters/gpu/gl/Texture.h"

class vtkOpenGLState;

namespace umbra {

// Reads only the renderer from the render state: the caster is set apart.
class vtkUmbraDepthPass : public vtkOpenGLRenderPass {
 public:
  static vtkUmbraDepthPass* New();
  vtkTypeMacro(vtkUmbraDepthPass, vtkOpenGLRenderPass);

  // The caster is in world coordinates and must outlive the next Render.
  void SetCaster(vtkProp* caster) { this->Caster = caster; }
  void SetLightFrame(const LightFrame& frame) { this->Frame = frame; }
  // The target has 32-bit floats of one channel. It gets linear depth in [0,1], top row first, 1
  // where nothing is. In an array, layers from `firstLayer` on are written, one for each sample of
  // a texel; a plain texture gets one sample.
  void SetTarget(const gl::Texture* target, int firstLayer = 0);
  // `samples` must be a number that the driver has (SamplesGiven).
  void SetSamples(int samples) { this->Samples = samples; }

  // How many samples a texel the driver gives where `asked` are asked for: the next number that it
  // has, or its largest. Needs a current context.
  static int SamplesGiven(int asked);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
                              std::string& fragmentShader, vtkAbstractMapper* mapper,
                              vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                           vtkOpenGLVertexArrayObject* vao) override;

 protected:
  vtkUmbraDepthPass() = default;
  ~vtkUmbraDepthPass() override = default;

 private:
  void PrepareFramebuffer();
  void AttachSamples(GLuint framebuffer);
  void DrawCaster(vtkRenderer* renderer, vtkOpenGLState* gl);
  void CopySamples();

  vtkProp* Caster = nullptr;
  LightFrame Frame;
  const gl::Texture* Target = nullptr;
  int FirstLayer = 0;
  int Samples = 1;
  gl::Texture DepthBuffer;
  // Used only with several samples: all samples of a texel, before they go to their layers.
  gl::MultisampleTexture SampleDepths, SampleDepthBuffer;
  gl::FramebufferHandle Framebuffer;
  gl::ProgramCache Programs;
};

}  // namespace umbra

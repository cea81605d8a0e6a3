// Draws what casts shadows from the light, depth only.
#pragma once

#include <vtkOpenGLRenderPass.h>

#include "filters/core/Light.h"
#include "filters/gpu/gl/Texture.h"

namespace umbra {

// Reads only the renderer from the render state: the caster is set apart.
class vtkUmbraDepthPass : public vtkOpenGLRenderPass {
 public:
  static vtkUmbraDepthPass* New();
  vtkTypeMacro(vtkUmbraDepthPass, vtkOpenGLRenderPass);

  // In world coordinates; must outlive the next Render.
  void SetCaster(vtkProp* caster) { this->Caster = caster; }
  void SetLightFrame(const LightFrame& frame) { this->Frame = frame; }
  // 32-bit float, one channel. Gets linear depth in [0,1], top row first, 1 where nothing is.
  void SetTarget(const gl::Texture* target) { this->Target = target; }

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

  vtkProp* Caster = nullptr;
  LightFrame Frame;
  const gl::Texture* Target = nullptr;
  gl::Texture DepthBuffer;
  gl::FramebufferHandle Framebuffer;
};

}  // namespace umbra

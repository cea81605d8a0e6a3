#include "filters/gpu/vtkUmbraDepthPass.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include "Depth_frag_glsl.h"
#include "Depth_vert_glsl.h"
#include "filters/gpu/LightUniforms.h"

namespace umbra {

vtkStandardNewMacro(vtkUmbraDepthPass);

void vtkUmbraDepthPass::PrepareFramebuffer() {
  this->DepthBuffer.require(GL_DEPTH_COMPONENT32F, this->Target->width(), this->Target->height());
  if (!this->Framebuffer) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    this->Framebuffer = gl::FramebufferHandle(name);
  }
  const GLuint name = this->Framebuffer.name();
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, this->Target->name(), 0);
  glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, this->DepthBuffer.name(), 0);
  const float nothing[] = {1.0f, 0.0f, 0.0f, 0.0f}, farthest = 1.0f;
  glClearNamedFramebufferfv(name, GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(name, GL_DEPTH, 0, &farthest);
}

void vtkUmbraDepthPass::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  vtkOpenGLState* gl = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(gl);
  const vtkOpenGLState::ScopedglScissor scissor(gl);
  const vtkOpenGLState::ScopedglEnableDisable blend(gl, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(gl, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(gl, GL_SCISSOR_TEST);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglEnable(GL_DEPTH_TEST);
  this->PrepareFramebuffer();

  gl->PushFramebufferBindings();
  gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer.name());
  unsigned int buffer = GL_COLOR_ATTACHMENT0;
  gl->vtkglDrawBuffers(1, &buffer);
  gl->vtkglViewport(0, 0, this->Target->width(), this->Target->height());
  // What lies before the near plane still casts its shadow, with depth 0.
  glEnable(GL_DEPTH_CLAMP);
  vtkProp* props[] = {this->Caster};
  vtkRenderState casters(renderer);
  casters.SetPropArrayAndCount(props, 1);
  this->PreRender(&casters);
  this->Caster->RenderOpaqueGeometry(renderer);
  this->PostRender(&casters);
  glDisable(GL_DEPTH_CLAMP);
  gl->PopFramebufferBindings();
}

void vtkUmbraDepthPass::ReleaseGraphicsResources(vtkWindow* window) {
  this->Framebuffer.reset();
  this->DepthBuffer = gl::Texture();
  this->Superclass::ReleaseGraphicsResources(window);
}

bool vtkUmbraDepthPass::PreReplaceShaderValues(std::string& vertexShader, std::string&,
                                               std::string& fragmentShader, vtkAbstractMapper*,
                                               vtkProp*) {
  // Texts without VTK's markers: the mapper's later replacements find nothing to add to them.
  vertexShader = Depth_vert_glsl;
  fragmentShader = Depth_frag_glsl;
  return true;
}

bool vtkUmbraDepthPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*,
                                            vtkOpenGLVertexArrayObject*) {
  const GLuint name = GLuint(program->GetHandle());
  const Eigen::Matrix4f worldToLight = this->Frame.worldToLight.cast<float>();
  gl::setUniformMatrix4(name, "umbraWorldToLight", worldToLight.data());
  setLightUniforms(name, this->Frame);
  return true;
}

}  // namespace umbra

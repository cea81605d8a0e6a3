#include "filters/gpu/vtkUmbraDepthPass.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <vector>

#include "DepthSamples_comp_glsl.h"
#include "Depth_frag_glsl.h"
#include "Depth_vert_glsl.h"
#include "filters/gpu/LightUniforms.h"
#include "filters/gpu/gl/DrawOrder.h"

namespace umbra {
namespace {

constexpr GLenum depthFormat = GL_DEPTH_COMPONENT32F;

// How many samples a texel multisampled textures of this format can have; the largest number is
// first.
std::vector<int> sampleCounts(GLenum format) {
  GLint count = 0;
  glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &count);
  std::vector<int> counts(count);
  glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES, count, counts.data());
  return counts;
}

}  // namespace

vtkStandardNewMacro(vtkUmbraDepthPass);

void vtkUmbraDepthPass::SetTarget(const gl::Texture* target, int firstLayer) {
  this->Target = target;
  this->FirstLayer = firstLayer;
}

int vtkUmbraDepthPass::SamplesGiven(int asked) {
  if (asked <= 1) return 1;
  const std::vector<int> colour = sampleCounts(GL_R32F), depth = sampleCounts(depthFormat);
  int given = 1;
  for (int count : colour) {  // the largest number is first
    if (std::find(depth.begin(), depth.end(), count) == depth.end()) continue;
    if (given == 1 || count >= asked) given = count;
  }
  return given;
}

void vtkUmbraDepthPass::AttachSamples(GLuint framebuffer) {
  const int width = this->Target->width(), height = this->Target->height();
  this->SampleDepths.require(GL_R32F, width, height, this->Samples);
  this->SampleDepthBuffer.require(depthFormat, width, height, this->Samples);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, this->SampleDepths.name(), 0);
  glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, this->SampleDepthBuffer.name(), 0);
}

void vtkUmbraDepthPass::PrepareFramebuffer() {
  if (!this->Framebuffer) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    this->Framebuffer = gl::FramebufferHandle(name);
  }
  const GLuint name = this->Framebuffer.name();
  if (this->Samples > 1) {
    this->AttachSamples(name);
  } else {
    this->SampleDepths.reset();
    this->SampleDepthBuffer.reset();
    this->DepthBuffer.require(depthFormat, this->Target->width(), this->Target->height());
    if (this->Target->layers() > 0)
      glNamedFramebufferTextureLayer(name, GL_COLOR_ATTACHMENT0, this->Target->name(), 0,
                                     this->FirstLayer);
    else
      glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, this->Target->name(), 0);
    glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, this->DepthBuffer.name(), 0);
  }
  const float nothing[] = {1.0f, 0.0f, 0.0f, 0.0f}, farthest = 1.0f;
  glClearNamedFramebufferfv(name, GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(name, GL_DEPTH, 0, &farthest);
}

void vtkUmbraDepthPass::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(gl);
  const vtkOpenGLState::ScopedglScissor scissor(gl);
  const vtkOpenGLState::ScopedglEnableDisable blend(gl, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(gl, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(gl, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglEnableDisable multisample(gl, GL_MULTISAMPLE);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglEnable(GL_MULTISAMPLE);
  this->PrepareFramebuffer();
  this->DrawCaster(renderer, gl);
  umbra::gl::finishDraws();
  if (this->Samples > 1) {
    // VTK remembers which program it bound last.
    window->GetShaderCache()->ReleaseCurrentShader();
    this->CopySamples();
  }
}

void vtkUmbraDepthPass::DrawCaster(vtkRenderer* renderer, vtkOpenGLState* gl) {
  gl->PushFramebufferBindings();
  gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer.name());
  unsigned int buffer = GL_COLOR_ATTACHMENT0;
  gl->vtkglDrawBuffers(1, &buffer);
  gl->vtkglViewport(0, 0, this->Target->width(), this->Target->height());
  // What lies before the near plane still casts its shadow, with depth 0.
  glEnable(GL_DEPTH_CLAMP);
  // Each sample has the depth of its own place.
  glMinSampleShading(1.0f);
  if (this->Samples > 1) glEnable(GL_SAMPLE_SHADING);
  vtkProp* props[] = {this->Caster};
  vtkRenderState casters(renderer);
  casters.SetPropArrayAndCount(props, 1);
  this->PreRender(&casters);
  this->Caster->RenderOpaqueGeometry(renderer);
  this->PostRender(&casters);
  glDisable(GL_SAMPLE_SHADING);
  glDisable(GL_DEPTH_CLAMP);
  gl->PopFramebufferBindings();
}

void vtkUmbraDepthPass::CopySamples() {
  const GLuint program = this->Programs.compute("depth samples", DepthSamples_comp_glsl);
  gl::setUniform(program, "umbraSamples", 0);
  gl::setUniform(program, "umbraFirstLayer", this->FirstLayer);
  glUseProgram(program);
  glBindTextureUnit(0, this->SampleDepths.name());
  glBindImageTexture(0, this->Target->name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
  glDispatchCompute(GLuint(this->Target->width() + 7) / 8, GLuint(this->Target->height() + 7) / 8,
                    GLuint(this->Samples));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  glBindTextureUnit(0, 0);
  glUseProgram(0);
}

void vtkUmbraDepthPass::ReleaseGraphicsResources(vtkWindow* window) {
  this->Framebuffer.reset();
  this->DepthBuffer = gl::Texture();
  this->SampleDepths.reset();
  this->SampleDepthBuffer.reset();
  this->Programs.clear();
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

#include "filters/gpu/vtkUmbraShadingPass.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureUnitManager.h>

#include <algorithm>
#include <vector>

#include "ShadeDeclarations_glsl.h"
#include "ShadeImplementation_glsl.h"
#include "filters/gpu/LightUniforms.h"
#include "filters/gpu/TechniqueShader.h"

namespace umbra {
namespace {

constexpr GLenum drawBuffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};

// Grounds and walls lie behind other objects: when they are drawn last, most of them is hidden and
// never shaded.
std::vector<vtkProp*> smallestFirst(const vtkRenderState* state) {
  vtkProp** first = state->GetPropArray();
  std::vector<vtkProp*> props(first, first + state->GetPropArrayCount());
  const auto size = [](vtkProp* prop) {
    return vtkBoundingBox(prop->GetBounds()).GetDiagonalLength();
  };
  std::stable_sort(props.begin(), props.end(),
                   [&](vtkProp* a, vtkProp* b) { return size(a) < size(b); });
  return props;
}

}  // namespace

vtkStandardNewMacro(vtkUmbraShadingPass);

vtkUmbraShadingPass::vtkUmbraShadingPass() {
  this->ActiveDrawBuffers = 2;
}

void vtkUmbraShadingPass::PrepareText() {
  this->ActiveDrawBuffers = this->Reads.needFootprints() ? 3 : 2;
  const bool spot = this->Frame.kind == LightKind::Spot;
  std::string text = std::string("#define UMBRA_SPOT ") + (spot ? "1\n" : "0\n") +
                     techniqueSource(*this->Shaded, this->Reads) + ShadeDeclarations_glsl;
  if (text == this->Declarations) return;
  this->Declarations = std::move(text);
  this->TextTime.Modified();
}

void vtkUmbraShadingPass::PrepareTransforms(vtkRenderer* renderer) {
  Eigen::Matrix4d worldToView;
  vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  for (int i = 0; i < 16; ++i) worldToView(i / 4, i % 4) = view->GetElement(i / 4, i % 4);
  this->ViewToLight = (this->Frame.worldToLight * worldToView.inverse()).cast<float>();
  const bool spot = this->Frame.kind == LightKind::Spot;
  Eigen::Vector4d toLight(0.0, 0.0, 0.0, spot ? 1.0 : 0.0);
  toLight.head<3>() = spot ? this->Frame.position : Eigen::Vector3d(-this->Frame.direction);
  this->ToLight = (worldToView * toLight).cast<float>();
  this->SplitPlane = {0.0f, 0.0f, -1.0f, 0.0f};
  if (const auto& frozen = this->Settings.map.cascades.frozen) {
    const Eigen::Vector3d forward = (frozen->target - frozen->position).normalized();
    const Eigen::Vector4d plane(forward.x(), forward.y(), forward.z(),
                                -forward.dot(frozen->position));
    this->SplitPlane = (worldToView.inverse().transpose() * plane).cast<float>();
  }
}

void vtkUmbraShadingPass::SetMaps(const gl::Texture* depth, const gl::Texture* channels,
                                  const gl::Texture* filtered) {
  this->DepthMap = depth;
  this->ChannelMap = channels;
  this->FilteredMap = filtered;
}

void vtkUmbraShadingPass::PrepareFramebuffer(vtkRenderer* renderer, int width, int height) {
  this->Colour.require(GL_RGBA8, width, height);
  this->Surfaces.require(GL_RGBA32F, width, height);
  if (this->Reads.needFootprints())
    this->Footprints.require(GL_RGBA32F, width, height);
  else
    this->Footprints = gl::Texture();
  // The format is the window's, so that the picture can be copied there.
  GLint window = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &window);
  const GLenum depth = gl::depthFormatOf(GLuint(window));
  this->Depth.require(depth == GL_NONE ? GL_DEPTH_COMPONENT32F : depth, width, height);
  if (!this->Framebuffer) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    this->Framebuffer = gl::FramebufferHandle(name);
  }
  const GLuint name = this->Framebuffer.name();
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, this->Colour.name(), 0);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, this->Surfaces.name(), 0);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT2, this->Footprints.name(), 0);
  glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, this->Depth.name(), 0);
  glNamedFramebufferDrawBuffers(name, this->ActiveDrawBuffers, drawBuffers);
  double background[3];
  renderer->GetBackground(background);
  const float colour[] = {float(background[0]), float(background[1]), float(background[2]), 1.0f};
  const float nothing[] = {-1.0f, -1.0f, 0.0f, 1.0f}, farthest = 1.0f;
  glClearNamedFramebufferfv(name, GL_COLOR, 0, colour);
  glClearNamedFramebufferfv(name, GL_COLOR, 1, nothing);
  const float point[] = {0.0f, 0.0f, 1.0f, 0.0f};
  if (this->Footprints) glClearNamedFramebufferfv(name, GL_COLOR, 2, point);
  glClearNamedFramebufferfv(name, GL_DEPTH, 0, &farthest);
}

void vtkUmbraShadingPass::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  vtkOpenGLState* gl = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);

  this->PrepareText();
  this->PrepareTransforms(renderer);

  const vtkOpenGLState::ScopedglViewport viewport(gl);
  const vtkOpenGLState::ScopedglScissor scissor(gl);
  const vtkOpenGLState::ScopedglEnableDisable blend(gl, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(gl, GL_SCISSOR_TEST);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  // The second target's fourth component is no opacity.
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglEnable(GL_DEPTH_TEST);
  this->PrepareFramebuffer(renderer, width, height);

  gl->PushFramebufferBindings();
  gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer.name());
  std::vector<GLenum> buffers(drawBuffers, drawBuffers + this->ActiveDrawBuffers);
  gl->vtkglDrawBuffers(unsigned(buffers.size()), buffers.data());
  gl->vtkglViewport(0, 0, width, height);

  vtkTextureUnitManager* units = gl->GetTextureUnitManager();
  this->DepthUnit = units->Allocate();
  this->ChannelUnit = units->Allocate();
  glBindTextureUnit(GLuint(this->DepthUnit), this->DepthMap->name());
  glBindTextureUnit(GLuint(this->ChannelUnit), this->ChannelMap->name());
  this->FilteredUnit = units->Allocate();
  glBindTextureUnit(GLuint(this->FilteredUnit), this->FilteredMap->name());
  this->PreRender(state);
  this->NumberOfRenderedProps = 0;
  for (vtkProp* prop : smallestFirst(state))
    this->NumberOfRenderedProps += prop->RenderOpaqueGeometry(renderer);
  this->PostRender(state);
  units->Free(this->FilteredUnit);
  units->Free(this->ChannelUnit);
  units->Free(this->DepthUnit);
  gl->PopFramebufferBindings();
}

void vtkUmbraShadingPass::ReleaseGraphicsResources(vtkWindow* window) {
  this->Framebuffer.reset();
  this->Colour = gl::Texture();
  this->Surfaces = gl::Texture();
  this->Footprints = gl::Texture();
  this->Depth = gl::Texture();
  this->Superclass::ReleaseGraphicsResources(window);
}

bool vtkUmbraShadingPass::PreReplaceShaderValues(std::string&, std::string&,
                                                 std::string& fragmentShader, vtkAbstractMapper*,
                                                 vtkProp*) {
  // Tables of sums are bits, and the language version of VTK's shaders has no functions to read
  // them as floats.
  vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::System::Dec",
      "//VTK::System::Dec\n#extension GL_ARB_shader_bit_encoding : enable\n", false);
  // The mapper then replaces the markers that the text still has by its own lighting.
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Dec",
                               this->Declarations + "\n//VTK::Light::Dec\n", false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl",
                               ShadeImplementation_glsl + std::string("\n//VTK::Light::Impl\n"),
                               false);
  return true;
}

bool vtkUmbraShadingPass::PostReplaceShaderValues(std::string&, std::string&,
                                                  std::string& fragmentShader, vtkAbstractMapper*,
                                                  vtkProp*) {
  // The casting light is VTK's light 0: Phong's diffuse and specular terms, and PBR's radiance.
  const bool diffuse =
      vtkShaderProgram::Substitute(fragmentShader, "(df * lightColor0)", "(df * umbraLight)");
  const bool specular =
      vtkShaderProgram::Substitute(fragmentShader, "(sf * lightColor0)", "(sf * umbraLight)");
  const bool physical = vtkShaderProgram::Substitute(fragmentShader, "radiance = lightColor0",
                                                     "radiance = umbraLight");
  if (!(diffuse && specular) && !physical) {
    vtkErrorMacro("VTK's lighting is not written as expected; the frame has no shadows");
    return false;
  }
  return true;
}

bool vtkUmbraShadingPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*,
                                              vtkProp*, vtkOpenGLVertexArrayObject*) {
  const GLuint name = GLuint(program->GetHandle());
  gl::setUniform(name, "umbraDepthMap", this->DepthUnit);
  gl::setUniform(name, "umbraChannelMap", this->ChannelUnit);
  gl::setUniform(name, "umbraMipMap", this->FilteredUnit);
  gl::setUniform(name, "umbraSat", this->FilteredUnit);
  gl::setUniformMatrix4(name, "umbraViewToLight", this->ViewToLight.data());
  gl::setUniform4(name, "umbraToLight", {this->ToLight.data(), 4});
  gl::setUniform(name, "umbraConstantBias", float(this->Settings.bias.constant));
  gl::setUniform(name, "umbraSlopeTexels", float(this->Settings.bias.slope));
  gl::setUniform(name, "umbraReceiverPlane", this->Settings.bias.receiverPlane ? 1.0f : 0.0f);
  const bool anisotropic = this->Reads.filter == ReadFilter::Anisotropic;
  gl::setUniform(name, "umbraAnisotropy",
                 anisotropic ? float(this->Settings.read.anisotropy) : 1.0f);
  gl::setUniform(name, "umbraSatSize", int(this->Settings.read.satSize));
  gl::setUniform(name, "umbraSatDistance", float(this->Settings.read.satDistance));
  std::vector<float> ends, seams;
  for (const Cascade& cascade : this->Cascades) {
    ends.push_back(float(cascade.farDistance));
    seams.push_back(float(cascade.seamDistance(this->Settings.map.cascades.seam)));
  }
  gl::setUniform4(name, "umbraSplitPlane", {this->SplitPlane.data(), 4});
  gl::setUniform(name, "umbraCascadeEnds", ends);
  gl::setUniform(name, "umbraCascadeSeams", seams);
  setLightUniforms(name, this->Frame);
  setTechniqueUniforms(name, *this->Shaded, readFormat(this->Settings.map.format, this->Reads));
  setReadUniforms(name, this->Reads);
  return true;
}

}  // namespace umbra

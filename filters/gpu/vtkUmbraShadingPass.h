// Draws the scene's own actors with VTK's lighting, in which the casting light's part is
// multiplied by the technique's visibility; beside the colour it writes what probes need.
#pragma once

#include <vtkOpenGLRenderPass.h>
#include <vtkTimeStamp.h>

#include <string>
#include <vector>

#include "filters/core/maps/Cascades.h"
#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/TechniqueShader.h"
#include "filters/gpu/gl/Texture.h"

class vtkOpenGLRenderWindow;

namespace umbra {

class vtkUmbraShadingPass : public vtkOpenGLRenderPass {
 public:
  static vtkUmbraShadingPass* New();
  vtkTypeMacro(vtkUmbraShadingPass, vtkOpenGLRenderPass);

  // All of these must outlive the next Render.
  void SetTechnique(Technique* technique) { this->Shaded = technique; }
  // `filtered` holds the channels' mip levels or summed-area table; it is read only where the
  // filter needs it.
  void SetMaps(const gl::Texture* depth, const gl::Texture* channels, const gl::Texture* filtered);
  void SetReads(const MapReads& reads) { this->Reads = reads; }
  // There are as many as the reads have; their seams are the settings'.
  void SetCascades(const std::vector<Cascade>& cascades) { this->Cascades = cascades; }
  void SetLightFrame(const LightFrame& frame) { this->Frame = frame; }
  void SetSettings(const FrameSettings& settings) { this->Settings = settings; }

  // Draws the state's opaque props at the size of the renderer. The camera and the lights must
  // have been set up.
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // Bottom row first, as OpenGL has it.
  const gl::Texture& GetColour() const { return this->Colour; }      // 8-bit RGBA
  const gl::Texture& GetSurfaces() const { return this->Surfaces; }  // as SurfaceImage takes them
  // x, y, probes, cascade + weight of the next; written only where the reads need footprints.
  const gl::Texture& GetFootprints() const { return this->Footprints; }
  const gl::Texture& GetDepth() const { return this->Depth; }  // the camera's, [0,1]
  GLuint GetFramebuffer() const { return this->Framebuffer.name(); }

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
                              std::string& fragmentShader, vtkAbstractMapper* mapper,
                              vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
                               std::string& fragmentShader, vtkAbstractMapper* mapper,
                               vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                           vtkOpenGLVertexArrayObject* vao) override;
  // The time is new when the injected text is: mappers rebuild their shaders then, and only then.
  vtkMTimeType GetShaderStageMTime() override { return this->TextTime.GetMTime(); }

 protected:
  vtkUmbraShadingPass();
  ~vtkUmbraShadingPass() override = default;

 private:
  void PrepareFramebuffer(vtkRenderer* renderer, int width, int height);
  void PrepareText();
  void PrepareTransforms(vtkRenderer* renderer);

  Technique* Shaded = nullptr;
  std::string Declarations;  // the injected text
  vtkTimeStamp TextTime;
  const gl::Texture* DepthMap = nullptr;
  const gl::Texture* ChannelMap = nullptr;
  const gl::Texture* FilteredMap = nullptr;
  LightFrame Frame;
  FrameSettings Settings;
  MapReads Reads;
  std::vector<Cascade> Cascades;
  Eigen::Matrix4f ViewToLight = Eigen::Matrix4f::Identity();
  Eigen::Vector4f ToLight = Eigen::Vector4f::UnitZ();   // for ShadeDeclarations.glsl
  Eigen::Vector4f SplitPlane{0.0f, 0.0f, -1.0f, 0.0f};  // for ShadeDeclarations.glsl
  int DepthUnit = 0, ChannelUnit = 1, FilteredUnit = 2;

  gl::Texture Colour, Surfaces, Footprints, Depth;
  gl::FramebufferHandle Framebuffer;
};

}  // namespace umbra

// Pictures of the window's scene as other techniques shade it, drawn beside the one on the screen.
#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QSize>
#include <memory>

#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "ui/picture/FrameEvidence.h"

class QOffscreenSurface;
class QOpenGLContext;
class vtkGenericOpenGLRenderWindow;
class vtkObject;

namespace umbra {

class ShadowRenderer;

// What a picture shows whatever the technique.
struct PictureSubject {
  std::shared_ptr<const Scene> scene;
  Light light;
  Camera camera;
  FrameSettings frame;
  QSize size;  // device pixels

  bool operator==(const PictureSubject&) const = default;
};

// What is kept of a frame: nothing, what its pixels read, or the maps that they read as well.
enum class KeptEvidence { None, Surfaces, Maps };

struct TechniqueDrawing {
  QImage picture;
  FrameEvidence evidence;  // empty images where none is kept
};

// Has an OpenGL context of its own: what the screen's frame knows of its pixels stays.
class TechniquePictures {
 public:
  // Throws NoOpenGL.
  TechniquePictures();
  ~TechniquePictures();
  TechniquePictures(const TechniquePictures&) = delete;
  TechniquePictures& operator=(const TechniquePictures&) = delete;

  // Splits that follow the map are at rest. Throws as ShadowRenderer::render does.
  TechniqueDrawing draw(const PictureSubject& subject, const Technique& technique,
                        KeptEvidence kept);

 private:
  void makeCurrent();
  FrameEvidence evidence(const Technique& technique, KeptEvidence kept);

  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  std::unique_ptr<ShadowRenderer> renderer_;
  PictureSubject drawn_;
};

}  // namespace umbra

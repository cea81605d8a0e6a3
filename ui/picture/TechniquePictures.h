// Pictures of the window's scene as other techniques shade it, drawn beside the one on the screen.
#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QSize>
#include <memory>

#include "filters/core/frame/FrameSnapshot.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

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

// Has an OpenGL context of its own: what the screen's frame knows of its pixels stays.
class TechniquePictures {
 public:
  // Throws NoOpenGL.
  TechniquePictures();
  ~TechniquePictures();
  TechniquePictures(const TechniquePictures&) = delete;
  TechniquePictures& operator=(const TechniquePictures&) = delete;

  // Splits that follow the map are at rest. Throws as ShadowRenderer::render does.
  QImage draw(const PictureSubject& subject, const Technique& technique);
  // What the last picture's frame left. Depth maps that the last frame of `live` (may be null) has
  // as well are shared with it.
  std::shared_ptr<const FrameSnapshot> snapshot(ShadowRenderer* live);

 private:
  void makeCurrent();

  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  std::unique_ptr<ShadowRenderer> renderer_;
  PictureSubject drawn_;
};

}  // namespace umbra

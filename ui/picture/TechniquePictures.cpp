#include "ui/picture/TechniquePictures.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include "filters/core/support/Error.h"
#include "filters/gpu/ShadowRenderer.h"

namespace umbra {
namespace {

// VTK asks the owner of a foreign context for what a window of its own would know.
template <class Answer>
void answer(vtkObject& window, unsigned long event, void* client, Answer function) {
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(client);
  command->SetCallback(function);
  window.AddObserver(event, command);
}

// Whoever had a context current has it again.
class CurrentContext {
 public:
  CurrentContext()
      : context_(QOpenGLContext::currentContext()),
        surface_(context_ ? context_->surface() : nullptr) {}
  ~CurrentContext() {
    if (context_) {
      context_->makeCurrent(surface_);
    } else if (QOpenGLContext* mine = QOpenGLContext::currentContext()) {
      mine->doneCurrent();
    }
  }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  QOpenGLContext* context_;
  QSurface* surface_;
};

}  // namespace

TechniquePictures::TechniquePictures()
    : surface_(std::make_unique<QOffscreenSurface>()),
      context_(std::make_unique<QOpenGLContext>()) {
  const CurrentContext before;
  const QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  surface_->setFormat(format);
  surface_->create();
  context_->setFormat(format);
  if (!context_->create() || !context_->makeCurrent(surface_.get()))
    throw Error(ErrorKind::NoOpenGL, "OpenGL: there is no second context to compare techniques in");
  answer(
      *window_, vtkCommand::WindowMakeCurrentEvent, this,
      +[](vtkObject*, unsigned long, void* self, void*) {
        static_cast<TechniquePictures*>(self)->makeCurrent();
      });
  answer(
      *window_, vtkCommand::WindowIsCurrentEvent, context_.get(),
      +[](vtkObject*, unsigned long, void* context, void* current) {
        *static_cast<bool*>(current) = QOpenGLContext::currentContext() == context;
      });
  window_->SetMultiSamples(0);
  window_->SetOwnContext(0);
  window_->SetReadyForRendering(true);
  window_->SetMapped(1);
  window_->OpenGLInit();
  renderer_ = std::make_unique<ShadowRenderer>(*window_);
}

TechniquePictures::~TechniquePictures() {
  const CurrentContext before;
  makeCurrent();  // the renderer's textures belong to this context
  renderer_.reset();
  window_->Finalize();
  window_->RemoveAllObservers();
  context_->doneCurrent();
}

void TechniquePictures::makeCurrent() {
  context_->makeCurrent(surface_.get());
}

QImage TechniquePictures::draw(const PictureSubject& subject, const Technique& technique) {
  const CurrentContext before;
  makeCurrent();
  const bool newScene = subject.scene != drawn_.scene;
  if (newScene) renderer_->setScene(subject.scene);
  if (newScene || !(subject.light == drawn_.light)) renderer_->setLight(subject.light);
  if (newScene || !(subject.camera == drawn_.camera)) renderer_->setCamera(subject.camera);
  if (subject.size != drawn_.size) window_->SetSize(subject.size.width(), subject.size.height());
  renderer_->setFrame(subject.frame);
  renderer_->setTechnique(technique);
  drawn_ = subject;
  renderer_->render();
  const Image<std::uint8_t> colour = renderer_->colour();
  const QImage picture(colour.values().data(), colour.width(), colour.height(), colour.width() * 3,
                       QImage::Format_RGB888);
  return picture.copy();
}

std::shared_ptr<const FrameSnapshot> TechniquePictures::snapshot(ShadowRenderer* live) {
  const CurrentContext before;
  makeCurrent();
  return renderer_->snapshot(live);
}

}  // namespace umbra

#include "filters/gpu/GlErrors.h"

#include <vtkCommand.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include "filters/gpu/gl/OpenGL.h"

namespace umbra {
namespace {

class vtkUmbraErrorObserver : public vtkCommand {
 public:
  static vtkUmbraErrorObserver* New() { return new vtkUmbraErrorObserver; }

  void Execute(vtkObject*, unsigned long, void* text) override {
    if (auto messages = this->Messages.lock(); messages && text)
      messages->emplace_back(static_cast<const char*>(text));
  }

  std::weak_ptr<std::vector<std::string>> Messages;
};

void GLAPIENTRY collect(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text,
                        const void* messages) {
  if (type == GL_DEBUG_TYPE_ERROR)
    static_cast<std::vector<std::string>*>(const_cast<void*>(messages))->emplace_back(text);
}

}  // namespace

VtkErrors::VtkErrors() : messages_(std::make_shared<std::vector<std::string>>()) {
  const auto observer = vtkSmartPointer<vtkUmbraErrorObserver>::Take(vtkUmbraErrorObserver::New());
  observer->Messages = messages_;
  tag_ = vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::ErrorEvent, observer);
}

VtkErrors::~VtkErrors() {
  vtkOutputWindow::GetInstance()->RemoveObserver(tag_);
}

GlErrors::GlErrors() : messages_(std::make_unique<std::vector<std::string>>()) {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect, messages_.get());
}

GlErrors::~GlErrors() {
  glDebugMessageCallback(nullptr, nullptr);
}

}  // namespace umbra

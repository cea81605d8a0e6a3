#include "filters/gpu/HeadlessWindow.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>

#include <memory>
#include <string>

#include "filters/core/support/Error.h"
#include "filters/gpu/gl/OpenGL.h"

namespace umbra {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::NoOpenGL,
              what +
                  "; off-screen drawing needs OpenGL 4.5 through EGL: install the Debian "
                  "packages libegl1 and libgl1-mesa-dri");
}

// A surfaceless context. EGL is loaded when first asked for, not linked: whoever needs no picture
// needs no EGL.
class EglContext {
 public:
  EglContext() {
    library_ = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library_) fail("there is no libEGL.so.1");
    getProcAddress_ = entry<decltype(&eglGetProcAddress)>("eglGetProcAddress");
    const auto getPlatformDisplay = PFNEGLGETPLATFORMDISPLAYEXTPROC(
        getProcAddress_ ? getProcAddress_("eglGetPlatformDisplayEXT") : nullptr);
    if (!getPlatformDisplay) fail("EGL knows no platforms");
    makeCurrent_ = entry<decltype(&eglMakeCurrent)>("eglMakeCurrent");
    getCurrent_ = entry<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");
    destroy_ = entry<decltype(&eglDestroyContext)>("eglDestroyContext");
    display_ = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY ||
        !entry<decltype(&eglInitialize)>("eglInitialize")(display_, nullptr, nullptr))
      fail("EGL has no surfaceless platform");
    context_ = createContext();
    if (context_ == EGL_NO_CONTEXT) fail("EGL gives no core context of version 4.5");
    if (!makeCurrent()) fail("the EGL context cannot be made current");
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() {
    // The display stays initialised: other windows of this process share it. The library stays
    // loaded for the same reason.
    if (context_ == EGL_NO_CONTEXT) return;
    if (isCurrent()) makeCurrent_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    destroy_(display_, context_);
  }

  bool makeCurrent() {
    return makeCurrent_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  bool isCurrent() const { return context_ != EGL_NO_CONTEXT && getCurrent_() == context_; }

  // The OpenGL function of that name; null where there is none.
  using Function = void (*)();
  Function function(const char* name) const { return getProcAddress_(name); }

 private:
  template <class Entry>
  Entry entry(const char* name) const {
    return reinterpret_cast<Entry>(dlsym(library_, name));
  }

  EGLContext createContext() const {
    const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT, EGL_NONE};
    const EGLint contextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    entry<decltype(&eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API);
    entry<decltype(&eglChooseConfig)>("eglChooseConfig")(display_, configAttributes, &config, 1,
                                                         &count);
    if (count == 0) return EGL_NO_CONTEXT;
    return entry<decltype(&eglCreateContext)>("eglCreateContext")(display_, config, EGL_NO_CONTEXT,
                                                                  contextAttributes);
  }

  void* library_ = nullptr;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  decltype(&eglGetProcAddress) getProcAddress_ = nullptr;
  decltype(&eglMakeCurrent) makeCurrent_ = nullptr;
  decltype(&eglGetCurrentContext) getCurrent_ = nullptr;
  decltype(&eglDestroyContext) destroy_ = nullptr;
};

class vtkUmbraHeadlessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static vtkUmbraHeadlessWindow* New();
  vtkTypeMacro(vtkUmbraHeadlessWindow, vtkGenericOpenGLRenderWindow);

  // Made before the window: a VTK object cannot fail while it is constructed.
  void SetContext(std::unique_ptr<EglContext> context) {
    this->Context = std::move(context);
#if UMBRA_VTK_LOADS_SYMBOLS
    this->SetOpenGLSymbolLoader(
        [](void* egl, const char* name) { return static_cast<EglContext*>(egl)->function(name); },
        this->Context.get());
#endif
  }

  void MakeCurrent() override {
    this->Context->makeCurrent();
  }
  bool IsCurrent() override {
    return this->Context->isCurrent();
  }
  int SupportsOpenGL() override {
    return 1;
  }
  vtkTypeBool IsDirect() override {
    return 1;
  }
  // VTK would ask the surface, of which there is none, for it; its own buffers have 32 bits.
  int GetDepthBufferSize() override {
    return 32;
  }

  // VTK would ask the surface for its colour buffer as well, and warn that there is none.
  int GetColorBufferSizes(int* rgba) override {
    for (int i = 0; rgba && i < 4; ++i) rgba[i] = 8;
    return 32;
  }

#if !UMBRA_VTK_LOADS_SYMBOLS
  void OpenGLInitContext() override {
    if (this->Initialized) return;
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // Without an X display GLEW finds no GLX; OpenGL's own functions are loaded all the same.
    this->GlewInitValid = status == GLEW_OK || status == GLEW_ERROR_NO_GLX_DISPLAY;
    this->Initialized = this->GlewInitValid;
  }
#endif

 protected:
  vtkUmbraHeadlessWindow() {
    // A new window asks for eightfold sampling by itself, which triples the frame time.
    this->SetMultiSamples(0);
    this->SetShowWindow(false);
    // There is no surface to copy a finished frame to; read-backs use VTK's own buffers.
    this->SetFrameBlitModeToNoBlit();
  }
  ~vtkUmbraHeadlessWindow() override {
    this->vtkUmbraHeadlessWindow::MakeCurrent();
    this->Finalize();
  }

 private:
  std::unique_ptr<EglContext> Context;
};
vtkStandardNewMacro(vtkUmbraHeadlessWindow);

}  // namespace

vtkSmartPointer<vtkRenderWindow> makeHeadlessWindow(int width, int height) {
  auto context = std::make_unique<EglContext>();
  const auto window = vtkSmartPointer<vtkUmbraHeadlessWindow>::New();
  window->SetContext(std::move(context));
  window->SetSize(width, height);
  window->MakeCurrent();
  window->OpenGLInit();
  if (!gl::hasVersion45()) fail("the EGL context is older than OpenGL 4.5");
  return window;
}

}  // namespace umbra

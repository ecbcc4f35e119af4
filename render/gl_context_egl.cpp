// SPDX-License-Identifier: MIT
#include "render/gl_context.h"
#include "render/shared_library.h"

#define EGL_NO_X11
#include <fmt/format.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace bedmix {

namespace {

/// The library and the one display of the program, which is never closed: Mesa gives out the same one again,
/// and contexts in other threads may need it.
struct Egl {
  SharedLibrary library{"libEGL.so.1"};
  decltype(&eglGetPlatformDisplay) getPlatformDisplay;
  decltype(&eglInitialize) initialize;
  decltype(&eglBindAPI) bindApi;
  decltype(&eglCreateContext) createContext;
  decltype(&eglDestroyContext) destroyContext;
  decltype(&eglMakeCurrent) makeCurrent;
  decltype(&eglGetProcAddress) getProcAddress;
  decltype(&eglQueryString) queryString;
  decltype(&eglGetError) getError;
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string problem;  // empty where all is well

  Egl();
  std::string lastError() const { return fmt::format("error {:#x}", getError()); }
};

Egl::Egl() {
  library.find(getPlatformDisplay, "eglGetPlatformDisplay");
  library.find(initialize, "eglInitialize");
  library.find(bindApi, "eglBindAPI");
  library.find(createContext, "eglCreateContext");
  library.find(destroyContext, "eglDestroyContext");
  library.find(makeCurrent, "eglMakeCurrent");
  library.find(getProcAddress, "eglGetProcAddress");
  library.find(queryString, "eglQueryString");
  library.find(getError, "eglGetError");
  problem = library.problem();
  if (!problem.empty()) return;
  display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) {
    problem = "no display without a screen (EGL_MESA_platform_surfaceless), " + lastError() +
              "; Mesa's EGL and its software driver are needed";
    return;
  }
  const std::string extensions = queryString(display, EGL_EXTENSIONS);
  for (const char* needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"})
    if (extensions.find(needed) == std::string::npos)
      problem = std::string(needed) + " is missing; Mesa's EGL has it";
}

class EglContext final : public GlContext {
 public:
  EglContext(const Egl& egl, EGLContext handle) : egl_(egl), handle_(handle) {}
  ~EglContext() override { egl_.destroyContext(egl_.display, handle_); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string name() const override { return "EGL"; }
  bool makeCurrent() override { return makeCurrent(handle_); }
  void release() override { makeCurrent(EGL_NO_CONTEXT); }
  Function function(const char* name) const override { return egl_.getProcAddress(name); }

 private:
  bool makeCurrent(EGLContext context) {
    egl_.bindApi(EGL_OPENGL_API);  // each thread has its own choice
    return egl_.makeCurrent(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  }

  const Egl& egl_;
  EGLContext handle_;
};

}  // namespace

Result<std::unique_ptr<GlContext>> createEglContext() {
  static const Egl egl;
  if (!egl.problem.empty()) return Diagnostic{{}, "EGL: " + egl.problem, Trouble::unavailable};
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  EGLContext handle = EGL_NO_CONTEXT;
  if (egl.bindApi(EGL_OPENGL_API))
    handle = egl.createContext(egl.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (handle == EGL_NO_CONTEXT)
    return Diagnostic{{}, "EGL: no OpenGL 3.3 context, " + egl.lastError(), Trouble::unavailable};
  return std::unique_ptr<GlContext>(std::make_unique<EglContext>(egl, handle));
}

}  // namespace bedmix

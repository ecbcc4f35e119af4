// SPDX-License-Identifier: MIT
#include "render/gl_context.h"

#include <GL/osmesa.h>

#include <cstdlib>
#include <mutex>
#include <string>

// What the sanitizers find inside Mesa is not ours: it keeps some 160 bytes of every context it destroys, and
// they do not see the locks between its threads.
extern "C" {
#ifdef __SANITIZE_ADDRESS__
const char* __lsan_default_suppressions();
const char* __lsan_default_options();
const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif
#ifdef __SANITIZE_THREAD__
const char* __tsan_default_suppressions();
const char* __tsan_default_suppressions() { return "race:libOSMesa.so"; }
#endif
}

namespace bedmix {

namespace {

class OsmesaContext final : public GlContext {
 public:
  explicit OsmesaContext(OSMesaContext context) : context_(context) {}
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  bool makeCurrent(Image& image) override {
    if (!OSMesaMakeCurrent(context_, image.rgba.data(), GL_UNSIGNED_BYTE, image.size.width,
                           image.size.height))
      return false;
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    return true;
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  Function function(const char* name) const override { return OSMesaGetProcAddress(name); }

 private:
  OSMesaContext context_;
};

}  // namespace

Result<std::unique_ptr<GlContext>> createGlContext(int threads) {
  static std::once_flag once;
  std::call_once(once, [threads] {
    // llvmpipe reads this once, and would else take every core from the solver.
    if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
  });
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context)
    return Diagnostic{
        {},
        "OSMesa gives no OpenGL 3.3 context, so nothing can be drawn; install libosmesa6 and unset "
        "GALLIUM_DRIVER and MESA_* in the environment",
        Trouble::unavailable};
  return std::unique_ptr<GlContext>(std::make_unique<OsmesaContext>(context));
}

}  // namespace bedmix

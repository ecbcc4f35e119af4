// SPDX-License-Identifier: MIT
#include "render/gl_context.h"
#include "render/shared_library.h"

#include <GL/glcorearb.h>

#include <array>
#include <cstdint>

namespace bedmix {

namespace {

// Of GL/osmesa.h, which newer distributions do not have. Mesa will never change it again.
struct OsmesaHandle;
constexpr int formatKey = 0x22, depthBitsKey = 0x30, profileKey = 0x33, coreProfile = 0x34, majorKey = 0x36,
              minorKey = 0x37;

struct Osmesa {
  SharedLibrary library{"libOSMesa.so.8"};
  OsmesaHandle* (*createContext)(const int* attributes, OsmesaHandle* sharing);
  void (*destroyContext)(OsmesaHandle*);
  GLboolean (*makeCurrent)(OsmesaHandle*, void* buffer, GLenum type, GLsizei width, GLsizei height);
  GlContext::Function (*getProcAddress)(const char* name);

  Osmesa() {
    library.find(createContext, "OSMesaCreateContextAttribs");
    library.find(destroyContext, "OSMesaDestroyContext");
    library.find(makeCurrent, "OSMesaMakeCurrent");
    library.find(getProcAddress, "OSMesaGetProcAddress");
  }
};

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext(const Osmesa& osmesa, OsmesaHandle* handle) : osmesa_(osmesa), handle_(handle) {}
  ~OsmesaContext() override { osmesa_.destroyContext(handle_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string name() const override { return "OSMesa"; }
  bool makeCurrent() override {
    return osmesa_.makeCurrent(handle_, window_.data(), GL_UNSIGNED_BYTE, side, side);
  }
  void release() override { osmesa_.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  Function function(const char* name) const override { return osmesa_.getProcAddress(name); }

 private:
  static constexpr int side = 1;
  const Osmesa& osmesa_;
  OsmesaHandle* handle_;
  std::array<std::uint8_t, 4 * side * side> window_{};  // OSMesa wants one to draw into
};

}  // namespace

Result<std::unique_ptr<GlContext>> createOsmesaContext() {
  static const Osmesa osmesa;
  if (const std::string& problem = osmesa.library.problem(); !problem.empty())
    return Diagnostic{{}, "OSMesa: " + problem, Trouble::unavailable};
  const int attributes[] = {formatKey, GL_RGBA, depthBitsKey, 0, profileKey, coreProfile,
                            majorKey,  3,       minorKey,     3, 0};
  OsmesaHandle* const handle = osmesa.createContext(attributes, nullptr);
  if (!handle)
    return Diagnostic{
        {},
        "OSMesa: no OpenGL 3.3 context; unset GALLIUM_DRIVER and what begins with MESA_ in the environment",
        Trouble::unavailable};
  return std::unique_ptr<GlContext>(std::make_unique<OsmesaContext>(osmesa, handle));
}

}  // namespace bedmix

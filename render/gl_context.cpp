// SPDX-License-Identifier: MIT
#include "render/gl_context.h"

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>

// What the sanitizers find inside Mesa is not ours: OSMesa keeps some 90 bytes of every context it destroys,
// and they do not see the locks between its threads, in OSMesa or in the driver that EGL opens.
extern "C" {
#ifdef __SANITIZE_ADDRESS__
const char* __lsan_default_suppressions();
const char* __lsan_default_options();
const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif
#ifdef __SANITIZE_THREAD__
const char* __tsan_default_suppressions();
const char* __tsan_default_suppressions() { return "race:libOSMesa.so\nrace:swrast_dri.so"; }
#endif
}

namespace bedmix {

namespace {

std::atomic<GlSource>& sourceInUse() {
  static std::atomic<GlSource> source = GlSource::automatic;
  return source;
}

void setOnce(const char* variable, const std::string& value) { setenv(variable, value.c_str(), 0); }

}  // namespace

GlSource glSource() { return sourceInUse(); }

void useGlSource(GlSource source) { sourceInUse() = source; }

Result<std::unique_ptr<GlContext>> createGlContext(int threads, GlSource source) {
  static std::once_flag once;
  std::call_once(once, [threads] {
    // llvmpipe reads this once, and would else take every core from the solver.
    if (threads > 0) setOnce("LP_NUM_THREADS", std::to_string(threads));
    // EGL would else draw with a graphics card where there is one, and give other bytes on each machine.
    setOnce("LIBGL_ALWAYS_SOFTWARE", "1");
  });
  if (source == GlSource::egl) return createEglContext();
  Result<std::unique_ptr<GlContext>> context = createOsmesaContext();
  if (context || source == GlSource::osmesa) return context;
  Result<std::unique_ptr<GlContext>> other = createEglContext();
  if (other) return other;
  return Diagnostic{
      {}, context.problems.front().message + "; " + other.problems.front().message, Trouble::unavailable};
}

}  // namespace bedmix

// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>
#include <string>

namespace bedmix {

/// A library of the system that is opened while the program runs and stays open. Its names stay its own, so
/// that two libraries may have the same.
class SharedLibrary {
 public:
  explicit SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) problem_ = dlerror();
  }

  /// Looks a function up; once one is missing, all that follow are null too.
  template <class Function>
  void find(Function*& function, const char* name) {
    function = nullptr;
    if (!problem_.empty()) return;
    function = reinterpret_cast<Function*>(dlsym(handle_, name));
    if (!function) problem_ = dlerror();
  }

  /// Why it is not there or what it lacks; empty where all is well.
  const std::string& problem() const { return problem_; }

 private:
  void* handle_;
  std::string problem_;
};

}  // namespace bedmix

// SPDX-License-Identifier: MIT
#include "replay/shared_memory.h"

#include <cerrno>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace bedmix {

namespace {

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category(), "cannot share memory with a process");
}

}  // namespace

SharedMemory::SharedMemory(std::size_t most)
    : descriptor_(memfd_create("bedmix", MFD_CLOEXEC)), most_(most), data_(nullptr) {
  if (descriptor_ < 0) fail(errno);
  void* const at = mmap(nullptr, most, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  if (at == MAP_FAILED) {
    const int error = errno;
    close(descriptor_);
    fail(error);
  }
  data_ = static_cast<std::byte*>(at);
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      most_(other.most_),
      data_(std::exchange(other.data_, nullptr)) {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(most_, other.most_);
  std::swap(data_, other.data_);
  return *this;
}

SharedMemory::~SharedMemory() {
  if (!data_) return;
  munmap(data_, most_);
  close(descriptor_);
}

void SharedMemory::open(std::size_t size) {
  if (size > most_) fail(ENOMEM);
  if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail(errno);
}

}  // namespace bedmix

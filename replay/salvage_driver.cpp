// SPDX-License-Identifier: MIT
#include "replay/salvage_driver.h"

#include "replay/file_driver.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bedmix {

namespace {

// Of a superblock of version 0, which is that of all trajectories.
constexpr haddr_t flagsAt = 20, endAt = 40;
constexpr std::size_t flagsSize = 4;

struct SalvagedFile : DriverFile {
  haddr_t size = 0;  // there
  haddr_t end = 0;   // that the superblock is made to say
};

SalvagedFile& of(H5FD_t* file) { return fileOf<SalvagedFile>(file); }
const SalvagedFile& of(const H5FD_t* file) { return fileOf<SalvagedFile>(file); }

bool readAll(int descriptor, unsigned char* into, std::size_t size, haddr_t at) {
  std::memset(into, 0xff, size);
  while (size > 0) {
    const ssize_t n = pread(descriptor, into, size, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n == 0;
    into += n, size -= static_cast<std::size_t>(n), at += static_cast<haddr_t>(n);
  }
  return true;
}

H5FD_t* openFile(const char* name, unsigned, hid_t, haddr_t most) {
  const int descriptor = open(name, O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  struct stat status {};
  haddr_t said = 0;
  if (fstat(descriptor, &status) != 0 ||
      !readAll(descriptor, reinterpret_cast<unsigned char*>(&said), sizeof said, endAt)) {
    close(descriptor);
    return nullptr;
  }
  auto* file = new SalvagedFile;
  file->descriptor = descriptor;
  file->size = static_cast<haddr_t>(status.st_size);
  file->end = said < most ? std::max(said, file->size) : file->size;
  return &file->base;
}

/// Bytes of `value` that lie `at` in the file, where a read covers them.
void overlay(const void* value, std::size_t size, haddr_t at, haddr_t readAt, std::size_t readSize,
             unsigned char* into) {
  for (std::size_t i = 0; i < size; ++i)
    if (at + i >= readAt && at + i < readAt + readSize)
      into[at + i - readAt] = static_cast<const unsigned char*>(value)[i];
}

herr_t readFile(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* into) {
  const SalvagedFile& file = of(base);
  auto* bytes = static_cast<unsigned char*>(into);
  if (!readAll(file.descriptor, bytes, size, at)) return -1;
  constexpr unsigned char noFlags[flagsSize] = {};
  overlay(noFlags, flagsSize, flagsAt, at, size, bytes);
  overlay(&file.end, sizeof file.end, endAt, at, size, bytes);
  return 0;
}

herr_t closeFile(H5FD_t* base) {
  SalvagedFile* file = &of(base);
  close(file->descriptor);
  delete file;
  return 0;
}

H5FD_class_t makeClass() {
  H5FD_class_t driver = commonDriver<SalvagedFile>("bedmix salvage");
  driver.open = openFile;
  driver.close = closeFile;
  driver.get_eof = [](const H5FD_t* file, H5FD_mem_t) { return of(file).end; };
  driver.read = readFile;
  driver.write = [](H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*) -> herr_t { return -1; };
  return driver;
}

}  // namespace

void useSalvageDriver(hid_t access) {
  static const H5FD_class_t driver = makeClass();
  static const hid_t id = H5FDregister(&driver);
  H5Pset_driver(access, id, nullptr);
}

}  // namespace bedmix

// SPDX-License-Identifier: MIT
#include "replay/commit_driver.h"

#include "replay/file_driver.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace bedmix {

namespace {

/// A change of the finished part.
struct HeldWrite {
  H5FD_mem_t type;
  haddr_t at;
  std::vector<unsigned char> bytes;
};

struct CommitFile : DriverFile {
  haddr_t finished = 0;  // end of what the last flush has written
  std::vector<HeldWrite> held;
  bool failed = false;
  bool rehearses = false;
};

CommitFile& of(H5FD_t* file) { return fileOf<CommitFile>(file); }
const CommitFile& of(const H5FD_t* file) { return fileOf<CommitFile>(file); }

/// Hands the system's reason to HDF5's error stack.
herr_t refuse(const char* reason) {
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_FILE, H5E_WRITEERROR, "%s", reason);
  return -1;
}

constexpr hsize_t nodeSize = 2048, pageSize = 4096;

bool writeAll(int descriptor, const unsigned char* bytes, std::size_t size, haddr_t at) {
  while (size > 0) {
    const ssize_t n = pwrite(descriptor, bytes, size, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes += n, size -= static_cast<std::size_t>(n), at += static_cast<haddr_t>(n);
  }
  return true;
}

/// Place in the order of a flush. The superblock first: it tells where the file ends. Then the trees that
/// find the chunks, from their roots to their leaves, so that a chunk stays reachable while a leaf is split;
/// the level is the sixth byte of a node. Headers last: they tell how many rows there are.
int rank(const HeldWrite& write) {
  constexpr int levels = 256;
  switch (write.type) {
    case H5FD_MEM_SUPER:
      return 0;
    case H5FD_MEM_BTREE:
      return write.bytes.size() > 5 ? levels - write.bytes[5] : levels;
    case H5FD_MEM_OHDR:
      return levels + 2;
    default:
      return levels + 1;
  }
}

H5FD_t* openFile(const char* name, unsigned flags, hid_t, haddr_t) {
  const int mode = ((flags & H5F_ACC_RDWR) ? O_RDWR : O_RDONLY) | ((flags & H5F_ACC_CREAT) ? O_CREAT : 0);
  const int descriptor = open(name, mode | O_CLOEXEC, 0666);
  if (descriptor < 0) return refuse(std::strerror(errno)), nullptr;
  struct stat status {};
  const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (taken || ((flags & H5F_ACC_TRUNC) && ftruncate(descriptor, 0) != 0) ||
      fstat(descriptor, &status) != 0) {
    refuse(taken ? "another program is writing it" : std::strerror(errno));
    close(descriptor);
    return nullptr;
  }
  auto* file = new CommitFile;
  file->descriptor = descriptor;
  file->finished = static_cast<haddr_t>(status.st_size);
  return &file->base;
}

herr_t writeFile(H5FD_t* base, H5FD_mem_t type, hid_t, haddr_t at, std::size_t size, const void* from) {
  CommitFile& file = of(base);
  if (file.failed) return 0;  // HDF5 may close in peace
  const auto* bytes = static_cast<const unsigned char*>(from);
  const bool isUnread = type == H5FD_MEM_DRAW && size > pageSize;
  std::size_t inside = at < file.finished && !isUnread ? std::min<std::size_t>(size, file.finished - at) : 0;
  if (file.rehearses) inside = size;
  if (inside > 0) file.held.push_back({type, at, {bytes, bytes + inside}});
  if (writeAll(file.descriptor, bytes + inside, size - inside, at + inside)) return 0;
  file.failed = true;
  return refuse(std::strerror(errno));
}

herr_t readFile(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* into) {
  const CommitFile& file = of(base);
  auto* bytes = static_cast<unsigned char*>(into);
  std::memset(bytes, 0, size);  // as beyond the file's end
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = pread(file.descriptor, bytes + done, size - done, static_cast<off_t>(at + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return refuse(std::strerror(errno));
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  for (const HeldWrite& write : file.held) {
    const haddr_t from = std::max(at, write.at), to = std::min(at + size, write.at + write.bytes.size());
    if (from < to) std::copy_n(write.bytes.data() + (from - write.at), to - from, bytes + (from - at));
  }
  return 0;
}

herr_t flushFile(H5FD_t* base, hid_t, hbool_t) {
  CommitFile& file = of(base);
  if (file.failed || file.rehearses) return 0;
  struct stat status {};
  if (fstat(file.descriptor, &status) == 0 && status.st_nlink == 0) {
    file.failed = true;
    return refuse("it has been deleted while it was being written");
  }
  std::stable_sort(file.held.begin(), file.held.end(),
                   [](const HeldWrite& a, const HeldWrite& b) { return rank(a) < rank(b); });
  for (const HeldWrite& write : file.held) {
    if (!writeAll(file.descriptor, write.bytes.data(), write.bytes.size(), write.at)) {
      file.failed = true;
      return refuse(std::strerror(errno));
    }
  }
  file.held.clear();
  file.finished = file.allocated;
  return 0;
}

/// Makes the file as long as its superblock will say. It is never made shorter.
herr_t extendFile(H5FD_t* base, hid_t, hbool_t) {
  CommitFile& file = of(base);
  struct stat status {};
  if (file.failed || file.rehearses ||
      (fstat(file.descriptor, &status) == 0 &&
       (static_cast<haddr_t>(status.st_size) >= file.allocated ||
        ftruncate(file.descriptor, static_cast<off_t>(file.allocated)) == 0)))
    return 0;
  file.failed = true;
  return refuse(std::strerror(errno));
}

herr_t closeFile(H5FD_t* base) {
  CommitFile* file = &of(base);
  herr_t result = flushFile(base, H5P_DEFAULT, true);
  if (file->failed && ftruncate(file->descriptor, static_cast<off_t>(file->finished)) != 0) result = -1;
  close(file->descriptor);
  delete file;
  return result;
}

H5FD_class_t makeClass() {
  H5FD_class_t driver = commonDriver<CommitFile>("bedmix commit");
  driver.open = openFile;
  driver.close = closeFile;
  driver.get_eof = [](const H5FD_t* file, H5FD_mem_t) -> haddr_t {
    struct stat status {};
    return fstat(of(file).descriptor, &status) == 0 ? static_cast<haddr_t>(status.st_size) : HADDR_UNDEF;
  };
  driver.read = readFile;
  driver.write = writeFile;
  driver.flush = flushFile;
  driver.truncate = extendFile;
  return driver;
}

H5FD_t* openRehearsal(const char* name, unsigned, hid_t access, haddr_t most) {
  H5FD_t* const base = openFile(name, H5F_ACC_RDONLY, access, most);
  if (base) of(base).rehearses = true;
  return base;
}

void use(hid_t access, hid_t driver) {
  H5Pset_driver(access, driver, nullptr);
  // A kill can tear a write apart, but only between pages: the nodes of the trees, 2 to 3.7 kB, get a page
  // each.
  H5Pset_alignment(access, nodeSize, pageSize);
}

}  // namespace

void useCommitDriver(hid_t access) {
  static const H5FD_class_t driver = makeClass();
  static const hid_t id = H5FDregister(&driver);
  use(access, id);
}

void useRehearsalDriver(hid_t access) {
  static const H5FD_class_t driver = [] {
    H5FD_class_t rehearsal = makeClass();
    rehearsal.name = "bedmix rehearsal";
    rehearsal.open = openRehearsal;
    return rehearsal;
  }();
  static const hid_t id = H5FDregister(&driver);
  use(access, id);
}

}  // namespace bedmix

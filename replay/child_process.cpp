// SPDX-License-Identifier: MIT
#include "replay/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <new>
#include <string.h>  // NOLINT: sigabbrev_np
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace bedmix {

namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit allowed{};
  getrlimit(what, &allowed);
  allowed.rlim_cur = std::min(most, allowed.rlim_max);
  setrlimit(what, &allowed);
}

constexpr int outOfMemory = 12;  // exit status

/// Leaves by _exit: buffers and files that are open here are the parent's.
[[noreturn]] void run(const ChildProcess::Work& task, int socket) {
  constexpr int first = 3;
  if (socket != first) dup2(socket, first);
  close_range(first + 1, ~0U, 0);  // a lock would hold as long as this process
  for (const int ours : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) std::signal(ours, SIG_IGN);
  std::signal(SIGXCPU, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  try {
    Channel parent(first);
    task(parent);
  } catch (const ChannelClosed&) {  // the parent needs no more
  } catch (const std::bad_alloc&) {
    _exit(outOfMemory);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

}  // namespace

ChildProcess::ChildProcess(const Work& task) : channel_(-1), id_(-1) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot start a process");
  id_ = fork();
  if (id_ == 0) run(task, ends[1]);
  const int error = errno;
  channel_ = Channel(ends[0]);
  close(ends[1]);
  if (id_ < 0) throw std::system_error(error, std::generic_category(), "cannot start a process");
}

ChildProcess::~ChildProcess() {
  if (id_ < 0) return;
  kill(id_, SIGKILL);
  end();
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : channel_(std::move(other.channel_)), id_(std::exchange(other.id_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(channel_, other.channel_);
  std::swap(id_, other.id_);
  return *this;
}

std::string ChildProcess::end() {
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
  id_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == outOfMemory) return "it asks for ever more memory";
  if (!WIFSIGNALED(status)) return "exit status " + std::to_string(WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGXCPU) return "it computes without end";
  const char* name = sigabbrev_np(WTERMSIG(status));
  return name ? std::string("SIG") + name : "signal " + std::to_string(WTERMSIG(status));
}

void ChildProcess::allowComputing(std::chrono::seconds most) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  limit(RLIMIT_CPU, static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + most.count()));
}

void ChildProcess::allowMemory(std::uintmax_t most) {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const auto half = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) / 2;
  const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  limit(RLIMIT_AS, (pages + std::min<rlim_t>(most / page, half)) * page);
}

}  // namespace bedmix

// SPDX-License-Identifier: MIT
#include "replay/child_process.h"

#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bedmix::test {
namespace {

/// Why a child ends that does nothing but this.
std::string endOf(const ChildProcess::Work& work) {
  ChildProcess child(work);
  EXPECT_THROW(child.channel().get<int>(), ChannelClosed);
  return child.end();
}

TEST(ChildProcess, AnswersWhatItIsAsked) {
  ChildProcess child([](Channel& parent) {
    for (;;) parent.putAll(parent.getAll<std::string>() + "?");
  });
  for (const std::size_t size : {0u, 1u, 5000u, 3'000'000u}) {
    const std::string asked(size, 'x');
    child.channel().putAll(asked);
    EXPECT_EQ(child.channel().getAll<std::string>(), asked + "?");
  }
}

TEST(ChildProcess, TellsWhyItEnds) {
  EXPECT_EQ(endOf([](Channel&) {}), "exit status 0");
  EXPECT_EQ(endOf([](Channel&) { throw std::runtime_error("trouble"); }), "exit status 1");
  EXPECT_EQ(endOf([](Channel&) { throw std::bad_alloc(); }), "it asks for ever more memory");
  EXPECT_EQ(endOf([](Channel&) { raise(SIGKILL); }), "SIGKILL");
}

TEST(ChildProcess, EndsWhenItComputesWithoutEnd) {
  EXPECT_EQ(endOf([](Channel&) {
              ChildProcess::allowComputing(std::chrono::seconds(0));
              while (std::clock() >= 0) continue;
            }),
            "it computes without end");
}

TEST(ChildProcess, MayBeAllowedToComputeOn) {
  ChildProcess child([](Channel& parent) {
    ChildProcess::allowComputing(std::chrono::seconds(0));
    ChildProcess::allowComputing(std::chrono::seconds(100));
    const std::clock_t start = std::clock();
    while (std::clock() - start < 2 * CLOCKS_PER_SEC) continue;
    parent.put(42);
  });
  EXPECT_EQ(child.channel().get<int>(), 42);
}

TEST(ChildProcess, TakesNoMoreMemoryThanItIsAllowed) {
  ChildProcess child([](Channel& parent) {
    const auto canTake = [](std::size_t size) {
      void* const taken = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      return taken != MAP_FAILED && munmap(taken, size) == 0;
    };
    ChildProcess::allowMemory(100'000'000);
    parent.put(canTake(50'000'000));
    parent.put(canTake(200'000'000));
  });
  EXPECT_TRUE(child.channel().get<bool>());
  EXPECT_FALSE(child.channel().get<bool>());
}

TEST(ChildProcess, TakesNoPartInCtrlC) {
  ChildProcess child([](Channel& parent) {
    parent.put(getpid());
    parent.put(parent.get<int>());
  });
  const auto id = child.channel().get<pid_t>();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) EXPECT_EQ(kill(id, signal), 0);
  child.channel().put(7);
  EXPECT_EQ(child.channel().get<int>(), 7);
}

TEST(ChildProcess, IsGoneWithItsOwner) {
  pid_t id = 0;
  {
    ChildProcess child([](Channel& parent) {
      parent.put(getpid());
      while (std::clock() >= 0) continue;
    });
    id = child.channel().get<pid_t>();
  }
  EXPECT_EQ(waitpid(id, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, HoldsNoFileOfItsParent) {
  const TemporaryFolder folder;
  const std::string path = folder / "file";
  const int file = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  ASSERT_EQ(flock(file, LOCK_EX | LOCK_NB), 0);
  ChildProcess child([](Channel& parent) {
    parent.put(0);
    parent.get<int>();
  });
  child.channel().get<int>();
  close(file);
  const int again = open(path.c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_EQ(flock(again, LOCK_EX | LOCK_NB), 0);
  close(again);
}

}  // namespace
}  // namespace bedmix::test

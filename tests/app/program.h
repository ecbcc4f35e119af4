// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace bedmix {

/// What a finished program leaves.
struct Outcome {
  int exitCode = -1;  // 128 + signal where one killed it
  std::string out, err;
};

/// A program in a process of its own, started at once, in `folder`.
class Program {
 public:
  Program(std::vector<std::string> arguments, const std::filesystem::path& folder);
  ~Program();  // kills it where it still runs
  Program(const Program&) = delete;

  /// Waits until `text` has been said on stderr; false where the program ends before.
  bool waitForMessage(const std::string& text);
  void send(int signal) const;
  /// From now on none of its files may grow beyond `bytes`, as on a disk that is full.
  void fillDisk(std::uint64_t bytes) const;
  Outcome wait();

 private:
  pid_t pid_ = -1;
  int errPipe_ = -1;
  std::filesystem::path outFile_;
  std::string err_;
};

/// A test with an empty folder of its own, in which it runs programs.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// Runs bedmix in the folder to its end.
  Outcome bedmix(std::vector<std::string> arguments) const;
  /// Starts bedmix in the folder.
  std::unique_ptr<Program> start(std::vector<std::string> arguments) const;
  /// Runs a bash command in the folder; $BEDMIX is the program.
  Outcome shell(const std::string& command) const;

  std::filesystem::path folder;
};

std::string readFile(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const std::string& text);

/// Whether `text` contains `part`, with both in the message where it does not.
::testing::AssertionResult contains(const std::string& text, const std::string& part);

}  // namespace bedmix

// SPDX-License-Identifier: MIT
#include "app/accuracy/tasks.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

namespace bedmix {

void TaskRunner::run(const std::string& name, const std::vector<Task>& tasks, int workers) {
  if (tasks.empty()) return;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const double all = std::accumulate(tasks.begin(), tasks.end(), 0.0,
                                     [](double sum, const Task& t) { return sum + t.cost; });
  ProgressLine progress(console_);
  std::mutex mutex;
  std::size_t next = 0;
  int done = 0;
  double doneCost = 0.0;

  const auto take = [&]() -> const Task* {
    const std::lock_guard lock(mutex);
    if (next == tasks.size() || failure_ || !mayBegin_()) return nullptr;
    return &tasks[next++];
  };
  const auto finish = [&](const Task& task, Sample sample) {
    const std::lock_guard lock(mutex);
    if (auto problem = log_.add(std::move(sample)); problem && !failure_) failure_ = problem;
    ++done;
    doneCost += task.cost;
    const double part = doneCost / all, wall = std::chrono::duration<double>(Clock::now() - start).count();
    progress.show(part, fmt::format("{}: {} of {} samples, {} left", name, done, tasks.size(),
                                    clockText(wall * (1.0 - part) / part)));
  };
  const auto work = [&] {
    while (const Task* task = take()) {
      Sample sample{task->key, {}, {}};
      bool whole = true;
      try {
        whole = task->measure(sample);
      } catch (const std::exception& e) {  // out of memory, mostly: it must not end the program from here
        sample.failure = e.what();
      }
      if (whole) finish(*task, std::move(sample));
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int w = 1; w < workers; ++w) helpers.emplace_back(work);
    work();
  }
  left_ += static_cast<int>(tasks.size()) - done;
}

}  // namespace bedmix

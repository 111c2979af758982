// SPDX-License-Identifier: Apache-2.0
/// Loops over threads. What is computed never depends on how many there are.
#pragma once

#include <cstddef>
#include <functional>

namespace alidade {

/// Calls body(i) once for every i < count, on at most `threads` threads (0: as many as the machine has), in no promised order. With one
/// thread the loop is a plain one, in order. An exception of `body` ends the loop and is thrown again here.
void parallel_for(size_t count, int threads, const std::function<void(size_t)>& body);

/// Items that one call of a for_ranges' body handles.
inline constexpr size_t kRange = 8192;

/// Calls body(first, end) for the ranges that count items fall into, in no promised order: range i begins at i * kRange.
template <class Body> void for_ranges(size_t count, int threads, const Body& body) {
    parallel_for((count + kRange - 1) / kRange, threads, [&](size_t i) { body(i * kRange, (i + 1) * kRange < count ? (i + 1) * kRange : count); });
}

/// Work that makes more work.
class Tasks {
  public:
    /// Calls task() once, on any of the threads, sooner or later.
    virtual void run(std::function<void()> task) = 0;

  protected:
    ~Tasks() = default;
};

/// Calls body(tasks), and waits for all that it and its tasks ask to be run, on at most `threads` threads (0: as many as the machine has). An exception ends the work, and is thrown again here.
/// A parallel_for in a task is shared with the threads of the tasks, whatever number it asks for.
void with_tasks(int threads, const std::function<void(Tasks&)>& body);

/// What `threads` = 0 means on this machine.
int hardware_threads();

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <utility>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace alidade {

namespace {

/// More threads than the machine has are asked for by tests; TBB would warn and give fewer. Of several such limits it takes the least: one for all, then.
void allow_many_threads() { static const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 1024); }

/// Does this thread run one of a Group's tasks?
thread_local bool in_task = false;

class Group final : public Tasks {
  public:
    void run(std::function<void()> task) override {
        group_.run([task = std::move(task)] {
            struct Inside {
                bool before = std::exchange(in_task, true);
                ~Inside() { in_task = before; }
            } inside;
            task();
        });
    }
    void wait() { group_.wait(); }

  private:
    tbb::task_group group_;
};

}  // namespace

int hardware_threads() { return tbb::this_task_arena::max_concurrency(); }

void parallel_for(size_t count, int threads, const std::function<void(size_t)>& body) {
    if (threads <= 0) threads = hardware_threads();
    if (threads == 1 || count < 2) {
        for (size_t i = 0; i < count; ++i) body(i);
        return;
    }
    const auto loop = [&] {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 1), [&](const auto& range) {
            for (size_t i = range.begin(); i < range.end(); ++i) body(i);
        }, tbb::simple_partitioner());
    };
    if (in_task) return tbb::this_task_arena::isolate(loop);   // while it waits, this thread begins no other task
    allow_many_threads();
    tbb::task_arena arena(threads);
    arena.execute(loop);
}

void with_tasks(int threads, const std::function<void(Tasks&)>& body) {
    if (threads <= 0) threads = hardware_threads();
    allow_many_threads();
    tbb::task_arena arena(threads);
    arena.execute([&] {
        Group group;
        group.run([&] { body(group); });
        group.wait();
    });
}

}  // namespace alidade

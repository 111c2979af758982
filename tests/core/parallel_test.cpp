// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace alidade {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const int threads : {0, 1, 2, 7}) {
        for (const size_t count : {0u, 1u, 2u, 3u, 1000u, 20001u}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(count, threads, [&](size_t i) { ++calls[i]; });
            for (size_t i = 0; i < count; ++i) ASSERT_EQ(calls[i], 1) << i << " of " << count << " on " << threads;
        }
    }
}

TEST(ParallelFor, OneThreadGoesInOrder) {
    std::vector<size_t> order;
    parallel_for(100, 1, [&](size_t i) { order.push_back(i); });
    std::vector<size_t> want(100);
    std::iota(want.begin(), want.end(), size_t(0));
    EXPECT_EQ(order, want);
}

TEST(ParallelFor, ThrowsWhatTheBodyThrows) {
    for (const int threads : {1, 2}) {
        const auto body = [](size_t i) {
            if (i == 500) throw std::runtime_error("at 500");
        };
        try {
            parallel_for(1000, threads, body);
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& e) {
            EXPECT_EQ(e.what(), std::string("at 500"));
        }
    }
}

TEST(ParallelFor, AnExceptionEndsTheLoop) {
    std::atomic<size_t> calls = 0;
    EXPECT_THROW(parallel_for(1000000, 2, [&](size_t) { ++calls; throw 1; }), int);
    EXPECT_LT(calls, 1000000u);
}

TEST(ParallelFor, LoopsNest) {
    std::atomic<int> sum = 0;
    parallel_for(10, 2, [&](size_t) { parallel_for(10, 2, [&](size_t j) { sum += int(j); }); });
    EXPECT_EQ(sum, 450);
    EXPECT_GE(hardware_threads(), 1);
}

/// Each task makes two until there are many: all are run before with_tasks() ends, on any number of threads.
TEST(Tasks, AllAreRunOnce) {
    for (const int threads : {0, 1, 2, 3, 16}) {
        std::vector<std::atomic<int>> calls(1024);
        const std::function<void(Tasks&, size_t)> grow = [&](Tasks& tasks, size_t i) {
            ++calls[i];
            for (const size_t child : {2 * i, 2 * i + 1})
                if (child < calls.size()) tasks.run([&grow, &tasks, child] { grow(tasks, child); });
        };
        with_tasks(threads, [&](Tasks& tasks) { grow(tasks, 1); });
        for (size_t i = 1; i < calls.size(); ++i) ASSERT_EQ(calls[i], 1) << i << " of " << threads;
    }
}

TEST(Tasks, ExceptionsAreThrownAgain) {
    for (const int threads : {1, 4})
        EXPECT_THROW(with_tasks(threads, [](Tasks& tasks) {
            for (int i = 0; i < 100; ++i) tasks.run([i] { if (i == 50) throw std::length_error("full"); });
        }), std::length_error);
}

TEST(Tasks, MayUseLoops) {
    std::atomic<int> sum{0};
    with_tasks(3, [&](Tasks& tasks) {
        for (int i = 0; i < 10; ++i) tasks.run([&] { parallel_for(100, 3, [&](size_t j) { sum += int(j); }); });
    });
    EXPECT_EQ(sum, 10 * 4950);
}

}  // namespace
}  // namespace alidade

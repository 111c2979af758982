// SPDX-License-Identifier: Apache-2.0
#include "tools/interrupt.h"

#include "tools/verbs.h"

#include <csignal>
#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(StopOnSignalDeathTest, HearsTheFirstSignalAndDiesOfTheSecond) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const auto raise_twice = [signal] {
            const StopOnSignal signals;
            if (signals.stop()) std::_Exit(1);
            std::raise(signal);
            if (!signals.stop()) std::_Exit(2);
            std::raise(signal);
        };
        EXPECT_EXIT(raise_twice(), testing::KilledBySignal(signal), "");
    }
}

TEST(StopOnSignalDeathTest, LeavesTheSystemsWayBehind) {
    const auto raise_afterwards = [] {
        { const StopOnSignal signals; }
        std::raise(SIGINT);
    };
    EXPECT_EXIT(raise_afterwards(), testing::KilledBySignal(SIGINT), "");
}

TEST(ExitOnSignalDeathTest, ExitsWithTheCodeOfAnInterruption) {
    const auto interrupted = [] {
        exit_on_signal();
        std::raise(SIGTERM);
    };
    EXPECT_EXIT(interrupted(), testing::ExitedWithCode(kInterrupted), "alidade: interrupted");
}

}  // namespace
}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Counters of the processor. Where there are none (most virtual machines) the same code counts what the system itself counts: pages that are touched first.
#include "stress/hardware.h"
#include "stress/run.h"
#include "stress/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/mman.h>

namespace alidade::test {
namespace {

constexpr size_t kPages = 1000, kPage = 4096;
constexpr std::array<CountedEvent, kEvents> kFaults{{{"page faults", PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS},
                                                     {"no such event", ~0u, ~uint64_t(0)},
                                                     {"page faults", PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS},
                                                     {"no such event", PERF_TYPE_SOFTWARE, ~uint64_t(0)}}};

/// Memory that is not there before it is written to: a fault a page.
struct Fresh {
    volatile char* memory = static_cast<char*>(mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    Fresh() { madvise(const_cast<char*>(memory), kPages * kPage, MADV_NOHUGEPAGE); }
    ~Fresh() { munmap(const_cast<char*>(memory), kPages * kPage); }
    /// Not sanitized: the sanitizer's own memory would be touched, too, and counted.
    [[gnu::no_sanitize_address]] void touch(size_t first, size_t end) const {
        for (size_t i = first; i < end; ++i) memory[i * kPage] = 1;
    }
};

TEST(Hardware, CountsBetweenStartAndStopAlone) {
    EventCounters counters(kFaults);
    if (!counters.counts()[0]) GTEST_SKIP() << "the system lets no events be counted (perf_event_open)";
    const Fresh fresh;
    fresh.touch(0, 200);
    counters.start();
    fresh.touch(200, 500);
    counters.stop();
    fresh.touch(500, 700);
    counters.resume();
    fresh.touch(700, kPages);
    counters.stop();
    const EventCounts counts = counters.counts();
    EXPECT_NEAR(*counts[0], 600, 20);
    EXPECT_NEAR(*counts[2], 600, 20);
    EXPECT_FALSE(counts[1] || counts[3]) << "what does not exist has no number";
    counters.start();
    counters.stop();
    EXPECT_LT(*counters.counts()[0], 20) << "from 0 again";
}

TEST(Hardware, StandsInTheTableWhereItWasCounted) {
    StressFigures figures;
    StressPeerFigures peer;
    peer.name = "bvh", peer.precision = "float", peer.build_seconds = {1, 1, 1};
    StressRayFigures rays;
    rays.rays = "primary", rays.count = 10, rays.rounds = 1, rays.seconds = {1, 1, 1};
    peer.rays = {rays};
    figures.peers = {peer, peer};
    EXPECT_THAT(stress_table(figures), testing::Not(testing::HasSubstr("instructions")));
    figures.peers[1].rays[0].events[0] = 1628;
    EXPECT_THAT(stress_table(figures), testing::ContainsRegex("unlike +instructions\n(.|\n)*primary .* -\n(.|\n)*primary .* 1628\n"));
    EXPECT_THAT(stress_table(figures), testing::Not(testing::HasSubstr("cycles")));
}

}  // namespace
}  // namespace alidade::test

#endif

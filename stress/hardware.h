// SPDX-License-Identifier: Apache-2.0
/// What the processor itself counts: instructions, cycles, misses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace alidade {

/// An event of Linux's perf_event_open(2).
struct CountedEvent {
    const char* name;
    uint32_t type;
    uint64_t config;
};

/// Instructions, cycles, misses of the last-level cache, branches that were foretold wrongly.
inline constexpr size_t kEvents = 4;
extern const std::array<CountedEvent, kEvents> kHardwareEvents;

/// How often each event came; nothing of those that cannot be counted.
using EventCounts = std::array<std::optional<double>, kEvents>;

/// Counts events of the thread that made it, in user mode, between start() and stop(). Where the system or the machine has no counters (most virtual machines have none) there is
/// nothing, and no error. Where there are fewer counters than events they take turns, and what is told is scaled to the whole time.
class EventCounters {
  public:
    explicit EventCounters(const std::array<CountedEvent, kEvents>& events = kHardwareEvents);
    ~EventCounters();
    EventCounters(const EventCounters&) = delete;
    EventCounters& operator=(const EventCounters&) = delete;

    void start();   ///< from 0
    void resume();
    void stop();
    EventCounts counts() const;   ///< since the last start()

  private:
    std::array<int, kEvents> files_;
};

}  // namespace alidade

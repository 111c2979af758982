// SPDX-License-Identifier: Apache-2.0
#include "stress/hardware.h"

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace alidade {

#ifdef __linux__

const std::array<CountedEvent, kEvents> kHardwareEvents{{{"instructions", PERF_TYPE_HARDWARE, PERF_COUNT_HW_INSTRUCTIONS},
                                                        {"cycles", PERF_TYPE_HARDWARE, PERF_COUNT_HW_CPU_CYCLES},
                                                        {"cache_misses", PERF_TYPE_HARDWARE, PERF_COUNT_HW_CACHE_MISSES},
                                                        {"branch_misses", PERF_TYPE_HARDWARE, PERF_COUNT_HW_BRANCH_MISSES}}};

namespace {

/// A file to read the event from, or -1.
int open_event(const CountedEvent& event) {
    perf_event_attr asked{};
    asked.size = sizeof asked;
    asked.type = event.type, asked.config = event.config;
    asked.disabled = 1, asked.exclude_kernel = 1, asked.exclude_hv = 1;
    asked.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    return int(syscall(SYS_perf_event_open, &asked, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
}

std::optional<double> count_in(int file) {
    struct {
        uint64_t count, enabled, running;
    } told{};
    if (file < 0 || read(file, &told, sizeof told) != ssize_t(sizeof told)) return std::nullopt;
    if (told.running == 0) return told.enabled == 0 ? std::optional(0.0) : std::nullopt;   // its turn never came
    return double(told.count) * (double(told.enabled) / double(told.running));
}

void control(const std::array<int, kEvents>& files, unsigned long what) {
    for (const int file : files)
        if (file >= 0) ioctl(file, what, 0);
}

}  // namespace

EventCounters::EventCounters(const std::array<CountedEvent, kEvents>& events) {
    for (size_t i = 0; i < kEvents; ++i) files_[i] = open_event(events[i]);
}

EventCounters::~EventCounters() {
    for (const int file : files_)
        if (file >= 0) close(file);
}

void EventCounters::start() { control(files_, PERF_EVENT_IOC_RESET), resume(); }
void EventCounters::resume() { control(files_, PERF_EVENT_IOC_ENABLE); }
void EventCounters::stop() { control(files_, PERF_EVENT_IOC_DISABLE); }

EventCounts EventCounters::counts() const {
    EventCounts out;
    for (size_t i = 0; i < kEvents; ++i) out[i] = count_in(files_[i]);
    return out;
}

#else

const std::array<CountedEvent, kEvents> kHardwareEvents{{{"instructions", 0, 0}, {"cycles", 0, 0}, {"cache_misses", 0, 0}, {"branch_misses", 0, 0}}};

EventCounters::EventCounters(const std::array<CountedEvent, kEvents>&) { files_.fill(-1); }
EventCounters::~EventCounters() = default;
void EventCounters::start() {}
void EventCounters::resume() {}
void EventCounters::stop() {}
EventCounts EventCounters::counts() const { return {}; }

#endif

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "stress/measure.h"

#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <limits>

namespace alidade {

namespace {

/// The number of kB behind `key` in a file of /proc, in bytes.
std::optional<size_t> proc_bytes(const char* path, const char* key) {
    std::FILE* file = std::fopen(path, "r");
    if (!file) return std::nullopt;
    char line[256];
    std::optional<size_t> found;
    unsigned long long kilobytes = 0;
    while (!found && std::fgets(line, sizeof line, file))
        if (std::strncmp(line, key, std::strlen(key)) == 0 && std::sscanf(line + std::strlen(key), " %llu", &kilobytes) == 1) found = size_t(kilobytes) * 1024;
    std::fclose(file);
    return found;
}

/// The mark falls to what is resident now.
bool reset_high_water() {
    std::FILE* file = std::fopen("/proc/self/clear_refs", "w");
    if (!file) return false;
    const bool put = std::fputs("5", file) >= 0;
    return std::fclose(file) == 0 && put;
}

}  // namespace

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

Spread spread_of(const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {median(values), *low, *high};
}

PeakMemory::PeakMemory() {
    malloc_trim(0);
    if (reset_high_water()) before_ = proc_bytes("/proc/self/status", "VmRSS:");
}

std::optional<size_t> PeakMemory::bytes() const {
    const auto high = proc_bytes("/proc/self/status", "VmHWM:");
    if (!before_ || !high) return std::nullopt;
    return *high > *before_ ? *high - *before_ : 0;
}

size_t available_memory() { return proc_bytes("/proc/meminfo", "MemAvailable:").value_or(0); }

}  // namespace alidade

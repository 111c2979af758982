// SPDX-License-Identifier: Apache-2.0
/// Runs a row's cases, and adds up what is found.
#include "core/parallel.h"
#include "numerics/suite.h"

#include <algorithm>
#include <bit>
#include <map>
#include <mutex>

namespace alidade {

const char* name(NumericsScale scale) {
    switch (scale) {
        case NumericsScale::size: return "size";
        case NumericsScale::offset: return "offset in sizes";
        case NumericsScale::distance: return "distance in sizes";
        case NumericsScale::angle: return "angle in radians";
        case NumericsScale::silhouette: return "from the silhouette in radii";
        case NumericsScale::gap: return "gap in sizes";
    }
    return "";
}

size_t NumericsTally::band(NumericsScale scale, int decade) {
    std::vector<NumericsBand>& bands = found_.bands;
    const auto known = std::find_if(bands.begin(), bands.end(), [&](const NumericsBand& b) { return b.scale == scale && b.decade == decade; });
    if (known == bands.end()) return bands.push_back({scale, decade}), bands.size() - 1;
    return size_t(known - bands.begin());
}

void NumericsTally::at(NumericsScale scale, double x) {
    if (x > 0 && std::isfinite(x) && bands_ < band_.size()) band_[bands_++] = band(scale, int(std::floor(std::log10(x))));
}

void NumericsTally::add(const NumericsTally& later) {
    const NumericsFound& other = later.found_;
    if (is_worse(other.worst, found_.worst)) found_.worst = other.worst, found_.worst_case = other.worst_case;
    if (found_.wrong == 0 || (found_.wrong == found_.excused && other.wrong > other.excused)) found_.first_wrong = other.first_wrong, found_.why = other.why;
    found_.cases += other.cases, found_.asked += other.asked, found_.wrong += other.wrong, found_.excused += other.excused;
    for (const NumericsBand& b : other.bands) {
        NumericsBand& mine = found_.bands[band(b.scale, b.decade)];
        mine.asked += b.asked, mine.wrong += b.wrong;
        if (is_worse(b.worst, mine.worst)) mine.worst = b.worst;
    }
}

namespace {

/// A run in parts, which threads take one after the other, and which are added up in their order.
class Run {
  public:
    Run(const NumericsRow& row, uint64_t first, uint64_t count, const NumericsWatch& watch)
        : row_(row), first_(first), count_(count), part_(std::bit_floor(std::clamp<uint64_t>(count / 256, 1, kMostCases))), watch_(watch) {}

    void work() {
        const auto check = row_.begin();
        for (uint64_t part; (part = next_++) * part_ < count_;) {
            NumericsTally tally;
            for (uint64_t i = part * part_, end = std::min(i + part_, count_); i < end; ++i) {
                if (watch_.stop && *watch_.stop) return;
                tally.begin_case(first_ + i);
                check(first_ + i, tally);
            }
            keep(part, std::move(tally));
        }
    }
    NumericsTally sum() && { return std::move(sum_); }

  private:
    static constexpr uint64_t kMostCases = 16384;   // of a part: more than share a mesh

    void keep(uint64_t part, NumericsTally tally) {
        const std::lock_guard lock(mutex_);
        early_.emplace(part, std::move(tally));
        for (auto next = early_.begin(); next != early_.end() && next->first == added_; next = early_.erase(next), ++added_) sum_.add(next->second);
        if (watch_.tell) watch_.tell(sum_);
    }

    const NumericsRow& row_;
    const uint64_t first_, count_, part_;
    const NumericsWatch& watch_;
    std::atomic<uint64_t> next_{0};
    std::mutex mutex_;
    std::map<uint64_t, NumericsTally> early_;   ///< of parts that were done before some part ahead of them
    uint64_t added_ = 0;                        ///< parts
    NumericsTally sum_;
};

}  // namespace

NumericsTally run_numerics(const NumericsRow& row, uint64_t first, uint64_t count, const NumericsWatch& watch) {
    Run run(row, first, count, watch);
    const int threads = watch.threads > 0 ? watch.threads : hardware_threads();
    parallel_for(size_t(threads), threads, [&](size_t) { run.work(); });
    return std::move(run).sum();
}

NumericsTally run_numerics(const NumericsRow& row, uint64_t first, uint64_t count) { return run_numerics(row, first, count, {}); }

}  // namespace alidade

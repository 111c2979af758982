// SPDX-License-Identifier: Apache-2.0
/// What is measured of the numbers: rows of a table, each with its own inputs, an oracle that does not round, and a goal.
#pragma once

#include "accel/accelerator.h"
#include "accel/intersect.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alidade {

/// What cases are told apart by, where a row says what holds at which of them.
enum class NumericsScale { size, offset, distance, angle, silhouette, gap };
/// As a page names it, with its unit.
const char* name(NumericsScale scale);

/// The answers to cases of one decade of a scale: 10^decade to 10^(decade + 1).
struct NumericsBand {
    NumericsScale scale;
    int decade;
    uint64_t asked = 0, wrong = 0;
    double worst = 0;
};

/// What a row found.
struct NumericsFound {
    uint64_t cases = 0, asked = 0, wrong = 0;
    uint64_t excused = 0;                       ///< of the wrong ones: in cases where the row is known to fall short
    uint64_t first_wrong = 0, worst_case = 0;   ///< cases; the first that is not excused, if there is one
    double worst = 0;
    std::string why;                            ///< the first wrong answer is wrong
    std::vector<NumericsBand> bands;            ///< in no order
};

/// Counts how many questions were asked, how many were answered wrongly, the worst error, and the first case that failed.
class NumericsTally {
  public:
    NumericsTally() = default;
    explicit NumericsTally(NumericsFound found) : found_(std::move(found)) {}

    void begin_case(uint64_t number) { case_ = number, ++found_.cases, bands_ = 0, falls_short_ = false; }
    /// Are wrong answers from here on to the end of the case of the kind that NumericsRow::falls_short tells?
    void falls_short(bool known) { falls_short_ = known; }
    /// The answers to this case belong to that place of the scale; at most two scales a case. 0 has no place.
    void at(NumericsScale scale, double x);
    /// An answer that is right or wrong. `what` is asked for the first wrong one alone, and the first that is not excused.
    template <class What> void decide(bool right, What&& what) {
        ++found_.asked;
        for (size_t i = 0; i < bands_; ++i) ++found_.bands[band_[i]].asked, found_.bands[band_[i]].wrong += !right;
        if (right) return;
        if (found_.wrong == 0 || (!falls_short_ && found_.wrong == found_.excused)) found_.first_wrong = case_, found_.why = what();
        ++found_.wrong, found_.excused += falls_short_;
    }
    /// An error, in the row's unit; what is above `goal` is wrong, and so is NaN.
    template <class What> void measure(double error, double goal, What&& what) {
        if (is_worse(error, found_.worst)) found_.worst = error, found_.worst_case = case_;
        for (size_t i = 0; i < bands_; ++i)
            if (double& worst = found_.bands[band_[i]].worst; is_worse(error, worst)) worst = error;
        decide(error <= goal, what);
    }
    /// What was found in the cases after these.
    void add(const NumericsTally& later);

    const NumericsFound& found() const { return found_; }
    uint64_t cases() const { return found_.cases; }
    uint64_t asked() const { return found_.asked; }
    uint64_t wrong() const { return found_.wrong; }
    uint64_t excused() const { return found_.excused; }
    double worst() const { return found_.worst; }
    uint64_t worst_case() const { return found_.worst_case; }
    uint64_t first_wrong() const { return found_.first_wrong; }
    const std::string& why() const { return found_.why; }

  private:
    static bool is_worse(double error, double worst) { return !(error <= worst) && !std::isnan(worst); }
    size_t band(NumericsScale scale, int decade);

    NumericsFound found_;
    uint64_t case_ = 0;
    std::array<size_t, 2> band_{};   ///< of this case
    size_t bands_ = 0;
    bool falls_short_ = false;
};

struct NumericsRow {
    const char* id;      ///< T01 ...
    const char* name;
    const char* asks;    ///< the inputs, the oracle, and the unit of the worst error
    const char* goal;
    uint64_t ci, full;   ///< cases of an ordinary and of a whole run
    /// What checks a case, for one thread. A case is a function of its number alone: a failure is made again by its number.
    std::function<void(uint64_t number, NumericsTally&)> (*begin)();
    const char* falls_short = "";   ///< how far the goal is known to be missed, and why: by no more than one answer of 1000
};

/// In the order of their ids.
std::span<const NumericsRow> numerics_suite();
/// The row of that id or name, or null.
const NumericsRow* find_numerics(std::string_view word);
/// Of which structures rows T01 to T06 and T15 to T18 ask.
struct NumericsAsked {
    Intersect intersect = Intersect::exact;   ///< goals are those of this
    std::optional<Precision> precision{};     ///< both, if none is named
};
/// To be called before a row is run.
void ask_numerics(const NumericsAsked& what);
/// Checks the cases first .. first + count - 1.
NumericsTally run_numerics(const NumericsRow& row, uint64_t first, uint64_t count);

/// How a long run goes on.
struct NumericsWatch {
    int threads = 1;                             ///< 0: as many as the machine has. What is found does not depend on them
    const std::atomic<bool>* stop = nullptr;     ///< ends the run at its next case
    /// What was found in all cases up to some place, now and then; under a lock.
    std::function<void(const NumericsTally& so_far)> tell;
};

/// The same with company; if it was stopped, what was told last.
NumericsTally run_numerics(const NumericsRow& row, uint64_t first, uint64_t count, const NumericsWatch& watch);

}  // namespace alidade

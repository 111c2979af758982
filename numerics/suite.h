// SPDX-License-Identifier: Apache-2.0
/// What is measured of the numbers: rows of a table, each with its own inputs, an oracle that does not round, and a goal.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace alidade {

/// What a row found: how many questions were asked, how many were answered wrongly, the worst error, and the first case that failed.
class NumericsTally {
  public:
    void begin_case(uint64_t number) { case_ = number; }
    /// An answer that is right or wrong. `what` is asked for the first wrong one alone.
    template <class What> void decide(bool right, What&& what) {
        ++asked_;
        if (!right && wrong_++ == 0) first_wrong_ = case_, why_ = what();
    }
    /// An error, in the row's unit; what is above `goal` is wrong, and so is NaN.
    template <class What> void measure(double error, double goal, What&& what) {
        if (!(error <= worst_) && !std::isnan(worst_)) worst_ = error, worst_case_ = case_;
        decide(error <= goal, what);
    }

    uint64_t asked() const { return asked_; }
    uint64_t wrong() const { return wrong_; }
    double worst() const { return worst_; }
    uint64_t worst_case() const { return worst_case_; }
    uint64_t first_wrong() const { return first_wrong_; }
    const std::string& why() const { return why_; }

  private:
    uint64_t case_ = 0, asked_ = 0, wrong_ = 0, first_wrong_ = 0, worst_case_ = 0;
    double worst_ = 0;
    std::string why_;
};

struct NumericsRow {
    const char* id;      ///< T01 ...
    const char* name;
    const char* asks;    ///< the inputs, the oracle, and the unit of the worst error
    const char* goal;
    const char* peers;   ///< what others were measured to do
    uint64_t ci, full;   ///< cases of an ordinary and of a whole run
    /// What checks a case. A case is a function of its number alone: a failure is made again by its number.
    std::function<void(uint64_t number, NumericsTally&)> (*begin)();
    const char* falls_short = "";   ///< how far the goal is known to be missed, and why: by no more than one answer of 1000
};

/// In the order of their ids.
std::span<const NumericsRow> numerics_suite();
/// The row of that id or name, or null.
const NumericsRow* find_numerics(std::string_view word);
/// Checks the cases first .. first + count - 1.
NumericsTally run_numerics(const NumericsRow& row, uint64_t first, uint64_t count);

}  // namespace alidade

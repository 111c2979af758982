// SPDX-License-Identifier: Apache-2.0
/// What a run of the numerical suite found, as tables of a page.
#pragma once

#include "numerics/suite.h"
#include "tools/json.h"

#include <cmath>
#include <string>
#include <vector>

namespace alidade {

/// A row that was run, whole or in part.
struct NumericsDone {
    const NumericsRow* row;
    uint64_t wanted = 0;        ///< cases
    double cpu_seconds = 0;
    NumericsTally tally;
    std::string begun{}, day{};   ///< "2026-11-23", UTC: when the first and the last of it was asked

    /// Is what it missed told, and no more than that: one answer of 1000, and what chance adds to a short run?
    bool as_known() const {
        const double most = double(tally.asked()) / 1000;
        return *row->falls_short && tally.wrong() == tally.excused() && double(tally.wrong()) <= most + 4 * std::sqrt(most);
    }
};

/// How much it was, and two Markdown tables: the rows; and what holds at which size, offset, distance and angle.
std::string as_markdown(const std::vector<NumericsDone>& rows);

/// All of it but the row's words, for a run that goes on later.
Json to_json(const NumericsDone& done);
/// False if it is not what to_json() wrote.
bool from_json(const Json& json, NumericsDone& done);

}  // namespace alidade

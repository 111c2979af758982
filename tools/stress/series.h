// SPDX-License-Identifier: Apache-2.0
/// Runs, one after the other, within the budgets.
#pragma once

#include "core/diagnostics.h"
#include "stress/growth.h"
#include "tools/stress/request.h"

namespace alidade {

struct StressSize {
    size_t asked = 0;          ///< triangles; 0 for a file
    std::string left_out;      ///< why there are no figures; empty if there are
    StressFigures figures;
    double make_seconds = 0;   ///< for the scene, on the clock
};

/// How a cost of one peer grows with the triangles.
struct StressGrowth {
    std::string peer, precision;
    std::string cost;          ///< "build seconds", "bytes", "primary tests", "primary seconds", ...; tests and seconds are of a ray
    PowerLaw law;
};

struct StressSeries {
    StressSource source;
    std::vector<StressSize> sizes;
    std::vector<StressGrowth> growth;   ///< empty for a single size
};

struct StressResults {
    std::vector<StressSeries> series;
    Diagnostics said;
    bool interrupted = false;
    double bytes = 0;                   ///< the budget in force

    size_t disagreements() const;
    bool measured() const;              ///< anything at all
};

/// Everything that is asked for, but for the files of figures. `told` hears of each size when it is done. Errors are in `said`: then nothing was measured.
StressResults measure_series(const StressRequest& request, const std::atomic<bool>& stop, const std::function<void(double fraction)>& progress,
                             const std::function<void(const StressSource&, const StressSize&)>& told);

/// "rays.bin" as "rays.primary.bin".
std::string rays_path(const std::string& path, const std::string& set);

}  // namespace alidade

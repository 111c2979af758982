// SPDX-License-Identifier: Apache-2.0
/// SIGINT and SIGTERM: a wish to stop, heard between rays.
#pragma once

#include <atomic>

namespace alidade {

/// While one lives, the first SIGINT or SIGTERM sets `stop()` (where that is not heard soon, the user is told) and the second ends the process as the system would. Before and after, both end it.
/// One at a time.
class StopOnSignal {
  public:
    StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    ~StopOnSignal();
    const std::atomic<bool>& stop() const;
};

/// Ends the process with the exit code of an interruption at the first SIGINT or SIGTERM: for the time in which there is nothing to write yet.
void exit_on_signal();

}  // namespace alidade

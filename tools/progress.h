// SPDX-License-Identifier: Apache-2.0
/// What a person, or a program that watches, sees of a render while it runs.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace alidade {

enum class ProgressMode {
    bar,    ///< one line, redrawn, where the stream is a terminal; elsewhere nothing
    json,   ///< one line every 10 %
    none,
};

/// One line of at most `columns` characters: a bar, percent, and the time left (from the time gone by, in seconds; unknown at fraction 0).
std::string progress_bar(double fraction, double elapsed, int columns);

/// Draws on `out` from construction to destruction, which erases the bar. Not for several threads at once: Monitor::progress is called under a lock.
class Progress {
  public:
    /// `what` is done, in the words of JSON.
    Progress(ProgressMode mode, std::FILE* out, const char* what = "tiles");
    Progress(const Progress&) = delete;
    ~Progress();
    void update(size_t done, size_t total);
    /// Erases the bar, for other words; update() draws it again.
    void hide();

  private:
    using Clock = std::chrono::steady_clock;
    void draw(double fraction);
    void print_json(size_t done, size_t total);

    ProgressMode mode_;
    std::FILE* out_;
    const char* what_;
    Clock::time_point start_ = Clock::now(), drawn_ = start_ - std::chrono::hours(1);
    size_t tenths_ = 0;
    bool visible_ = false;
};

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "tools/progress.h"

#include <algorithm>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace alidade {

namespace {

int columns_of(std::FILE* terminal) {
    winsize size{};
    if (ioctl(fileno(terminal), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

/// 75 -> "1:15", 3675 -> "1:01:15".
std::string clock_text(double seconds) {
    const auto whole = int64_t(std::min(seconds, 359999.0) + 0.5);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

double seconds_left(double fraction, double elapsed) { return elapsed * (1 - fraction) / fraction; }

}  // namespace

std::string progress_bar(double fraction, double elapsed, int columns) {
    fraction = std::clamp(fraction, 0.0, 1.0);
    const std::string left = fraction > 0 ? clock_text(seconds_left(fraction, elapsed)) + " left" : "";
    const std::string text = fmt::format("{:3.0f} % {:>12}", std::floor(100 * fraction), left);
    const int room = std::min(columns, 80) - int(text.size()) - 3;   // brackets and a space
    if (room < 10) return text.substr(0, size_t(std::max(columns, 0)));
    const auto full = size_t(fraction * room);
    return fmt::format("[{}{}] {}", std::string(full, '#'), std::string(size_t(room) - full, '.'), text);
}

Progress::Progress(ProgressMode mode, std::FILE* out, const char* what) : mode_(mode), out_(out), what_(what) {
    if (mode_ == ProgressMode::bar && !isatty(fileno(out))) mode_ = ProgressMode::none;
}

Progress::~Progress() { hide(); }

void Progress::hide() {
    if (visible_) fmt::print(out_, "\r\033[K"), std::fflush(out_);
    visible_ = false;
}

void Progress::update(size_t done, size_t total) {
    if (total == 0) return;
    if (mode_ == ProgressMode::bar) draw(double(done) / double(total));
    if (mode_ == ProgressMode::json) print_json(done, total);
}

void Progress::draw(double fraction) {
    const auto now = Clock::now();
    if (now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;
    visible_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    fmt::print(out_, "\r{}\033[K", progress_bar(fraction, elapsed, columns_of(out_) - 1));   // the last column would wrap
    std::fflush(out_);
}

void Progress::print_json(size_t done, size_t total) {
    const size_t tenths = done * 10 / total;
    if (tenths <= tenths_) return;
    tenths_ = tenths;
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count(), fraction = double(done) / double(total);
    fmt::print(out_, R"({{"progress": {:.4f}, "{}_done": {}, "{}": {}, "seconds": {:.3f}, "seconds_left": {:.3f}}})"
               "\n", fraction, what_, done, what_, total, elapsed, seconds_left(fraction, elapsed));
    std::fflush(out_);
}

}  // namespace alidade

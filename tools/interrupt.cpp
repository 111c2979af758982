// SPDX-License-Identifier: Apache-2.0
#include "tools/interrupt.h"

#include "tools/verbs.h"

#include <csignal>
#include <initializer_list>
#include <string_view>
#include <unistd.h>

namespace alidade {

namespace {

std::atomic<bool> stop_flag{false};   // a signal handler can only reach what is global
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::initializer_list<int> kWishes = {SIGINT, SIGTERM};

void handle(std::initializer_list<int> signals, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    for (const int signal : signals) sigaction(signal, &action, nullptr);
}

/// A pixel has no end that is near: a pattern may iterate for hours, and to ask it for the flag would cost all others.
void tell_of_pixel(int) {
    constexpr std::string_view text = "\nalidade: a pixel that takes long is under way: a second signal ends the program without it\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

void set_stop(int) {
    constexpr unsigned kPatience = 2;   // seconds
    stop_flag = true;
    alarm(kPatience);
}

void exit_interrupted(int) {
    constexpr std::string_view text = "alidade: interrupted\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
    _exit(kInterrupted);
}

}  // namespace

StopOnSignal::StopOnSignal() {
    stop_flag = false;
    handle({SIGALRM}, tell_of_pixel, SA_RESTART);
    handle(kWishes, set_stop, int(SA_RESETHAND) | SA_RESTART);   // reset: the second signal is not ours
}

StopOnSignal::~StopOnSignal() {
    handle(kWishes, SIG_DFL, 0);
    alarm(0);
    handle({SIGALRM}, SIG_DFL, 0);
}

const std::atomic<bool>& StopOnSignal::stop() const { return stop_flag; }

void exit_on_signal() { handle(kWishes, exit_interrupted, 0); }

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "tools/interrupt.h"

#include "tools/verbs.h"

#include <csignal>
#include <string_view>
#include <unistd.h>

namespace alidade {

namespace {

std::atomic<bool> stop_flag{false};   // a signal handler can only reach what is global
static_assert(std::atomic<bool>::is_always_lock_free);

void handle(void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

void set_stop(int) { stop_flag = true; }

void exit_interrupted(int) {
    constexpr std::string_view text = "alidade: interrupted\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
    _exit(kInterrupted);
}

}  // namespace

StopOnSignal::StopOnSignal() {
    stop_flag = false;
    handle(set_stop, int(SA_RESETHAND) | SA_RESTART);   // reset: the second signal is not ours
}

StopOnSignal::~StopOnSignal() { handle(SIG_DFL, 0); }

const std::atomic<bool>& StopOnSignal::stop() const { return stop_flag; }

void exit_on_signal() { handle(exit_interrupted, 0); }

}  // namespace alidade

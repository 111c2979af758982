// SPDX-License-Identifier: Apache-2.0
#include "core/deep_stack.h"

#include <cstddef>
#include <exception>
#include <pthread.h>

namespace alidade {

namespace {

/// Objects of objects take some 2.5 kB a level while they are read and built, of which pov::Limits allows 50,000 at the most.
constexpr size_t kBytes = size_t(1) << 28;

struct Call {
    const std::function<void()>& f;
    std::exception_ptr thrown = nullptr;
};

void* run(void* given) {
    Call& call = *static_cast<Call*>(given);
    try {
        call.f();
    } catch (...) {
        call.thrown = std::current_exception();
    }
    return nullptr;
}

}  // namespace

void run_on_deep_stack(const std::function<void()>& f) {
    Call call{f};
    pthread_attr_t attributes;
    pthread_t thread;
    if (pthread_attr_init(&attributes) != 0) return f();
    const bool started = pthread_attr_setstacksize(&attributes, kBytes) == 0 && pthread_create(&thread, &attributes, run, &call) == 0;
    pthread_attr_destroy(&attributes);
    if (!started) return f();
    pthread_join(thread, nullptr);
    if (call.thrown) std::rethrow_exception(call.thrown);
}

}  // namespace alidade

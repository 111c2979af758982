// SPDX-License-Identifier: Apache-2.0
#include "core/deep_stack.h"

#include <exception>
#include <pthread.h>

namespace alidade {

namespace {

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

void run_on_deep_stack(size_t bytes, const std::function<void()>& f) {
    Call call{f};
    pthread_attr_t attributes;
    pthread_t thread;
    if (pthread_attr_init(&attributes) != 0) return f();
    const bool started = pthread_attr_setstacksize(&attributes, bytes) == 0 && pthread_create(&thread, &attributes, run, &call) == 0;
    pthread_attr_destroy(&attributes);
    if (!started) return f();
    pthread_join(thread, nullptr);
    if (call.thrown) std::rethrow_exception(call.thrown);
}

}  // namespace alidade

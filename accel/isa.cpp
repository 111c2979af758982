// SPDX-License-Identifier: Apache-2.0
#include "accel/isa.h"

#include "hwy/targets.h"

#include <vector>

namespace alidade {

namespace {

/// As the tables of isa_table.h are.
constexpr Isa kCompiled[] = {
    Isa::scalar,
#if HWY_TARGETS & HWY_SSE4
    Isa::sse4,
#endif
#if HWY_TARGETS & HWY_AVX2
    Isa::avx2,
#endif
#if HWY_TARGETS & HWY_AVX3
    Isa::avx512,
#endif
};

}  // namespace

/// What Highway's targets ask of the processor, and of the system. Not by Highway's own library: to load it takes longer than a small picture, since it measures the clock.
bool machine_has(Isa isa) {
#ifdef __x86_64__
    switch (isa) {
        case Isa::best:
        case Isa::scalar: return true;
        case Isa::sse4: return __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
        case Isa::avx2: return machine_has(Isa::sse4) && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        case Isa::avx512:
            return machine_has(Isa::avx2) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512cd");
    }
#endif
    return isa == Isa::best || isa == Isa::scalar;
}

std::span<const Isa> available_isas() {
    static const std::vector<Isa> isas = [] {
        std::vector<Isa> found;
        for (const Isa isa : kCompiled) {
            if (machine_has(isa)) found.push_back(isa);
        }
        return found;
    }();
    return isas;
}

const char* name(Isa isa) {
    switch (isa) {
        case Isa::best: return "best";
        case Isa::scalar: return "scalar";
        case Isa::sse4: return "sse4";
        case Isa::avx2: return "avx2";
        case Isa::avx512: return "avx512";
    }
    return "unknown";
}

}  // namespace alidade

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

bool machine_has(Isa isa) {
    static const int64_t targets = hwy::SupportedTargets();   // asks the processor, which takes long on a virtual machine
    switch (isa) {
        case Isa::best:
        case Isa::scalar: return true;
        case Isa::sse4: return (targets & HWY_SSE4) != 0;
        case Isa::avx2: return (targets & HWY_AVX2) != 0;
        case Isa::avx512: return (targets & HWY_AVX3) != 0;
    }
    return false;
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

// SPDX-License-Identifier: Apache-2.0
/// Tables of what a file was compiled for, from the plainest to the widest: for files that include themselves once for each target (hwy/foreach_target.h), to be used behind HWY_ONCE.
#pragma once

#include "accel/isa.h"

#include "hwy/targets.h"

#include <cstddef>

namespace alidade {

template <class T> struct IsaRow {
    Isa isa;
    T what;
};

/// Of a table, what is for `isa`, which for `best` is the widest that this machine has; the first, `scalar`, where it has not what was asked for.
template <class T, size_t count> const T& chosen(const IsaRow<T> (&rows)[count], Isa isa) {
    const IsaRow<T>* found = &rows[0];
    for (const IsaRow<T>& row : rows) {
        if (machine_has(row.isa) && (isa == Isa::best || isa == row.isa)) found = &row;
    }
    return found->what;
}

}  // namespace alidade

// What is named is of the target's namespace, alidade::N_AVX2 for one.
#if HWY_TARGETS & HWY_SSE4
#define ALIDADE_SSE4_ROW(...) {alidade::Isa::sse4, N_SSE4::__VA_ARGS__},
#else
#define ALIDADE_SSE4_ROW(...)
#endif
#if HWY_TARGETS & HWY_AVX2
#define ALIDADE_AVX2_ROW(...) {alidade::Isa::avx2, N_AVX2::__VA_ARGS__},
#else
#define ALIDADE_AVX2_ROW(...)
#endif
#if HWY_TARGETS & HWY_AVX3
#define ALIDADE_AVX512_ROW(...) {alidade::Isa::avx512, N_AVX3::__VA_ARGS__},
#else
#define ALIDADE_AVX512_ROW(...)
#endif
/// A whole table of IsaRow: `plain` (in parentheses if it has commas) without vectors, then the rest for each target.
#define ALIDADE_ISA_ROWS(plain, ...) {alidade::Isa::scalar, plain}, ALIDADE_SSE4_ROW(__VA_ARGS__) ALIDADE_AVX2_ROW(__VA_ARGS__) ALIDADE_AVX512_ROW(__VA_ARGS__)

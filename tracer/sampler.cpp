// SPDX-License-Identifier: Apache-2.0
#include "tracer/sampler.h"

#include "core/lanes.h"

#include <algorithm>
#include <array>

namespace alidade {
namespace {

constexpr uint64_t reversed(uint64_t x) {
    x = __builtin_bswap64(x);
    x = (x & 0x0f0f0f0f0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0f0f0f0f0fu);
    x = (x & 0x3333333333333333u) << 2 | (x >> 2 & 0x3333333333333333u);
    return (x & 0x5555555555555555u) << 1 | (x >> 1 & 0x5555555555555555u);
}
constexpr uint32_t reversed(uint32_t x) { return uint32_t(reversed(uint64_t(x)) >> 32); }

double to_unit(uint32_t x) { return x * 0x1p-32; }

/// Owen's nested uniform scrambling of the binary digits of a number, the lowest digit first, as a hash: a digit is flipped by those below it.
/// Source   Laine and Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011, in Burley's use, "Practical Hash-based Owen
///          Scrambling", JCGT 9(4), 2020.
uint32_t scrambled_from_below(uint32_t x, uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

/// The same of the digits of x / 2^32 and y / 2^32, the highest first; of one seed each, the lower half that of x.
Vec2 owen_scrambled(uint32_t x, uint32_t y, uint64_t seeds) {
    const uint64_t digits = reversed(uint64_t(x) << 32 | y);   // of x below those of y
    const uint64_t scrambled = reversed(uint64_t(scrambled_from_below(uint32_t(digits >> 32), uint32_t(seeds >> 32))) << 32 | scrambled_from_below(uint32_t(digits), uint32_t(seeds)));
    return {to_unit(uint32_t(scrambled >> 32)), to_unit(uint32_t(scrambled))};
}

/// The second dimension of Sobol's sequence, direction numbers of the polynomial x + 1, from the first, which is the reversed index. The matrix of that
/// map is Pascal's triangle modulo 2, a Kronecker power of (1 1; 0 1): one step for each factor.
uint32_t sobol_second(uint32_t first) {
    uint32_t x = first;
    x ^= x << 16;
    x ^= (x & 0x00ff00ffu) << 8;
    x ^= (x & 0x0f0f0f0fu) << 4;
    x ^= (x & 0x33333333u) << 2;
    return x ^ ((x & 0x55555555u) << 1);
}

/// In which order a pair of coordinates takes the sequence: what each binary digit of an index adds to the one that is taken, the lowest first; digits above stay. A triangular matrix over GF(2),
/// so that aligned blocks of 2^k are permuted, and the pair stays a (0, 2)-sequence.
using Order = std::array<uint16_t, 16>;

/// Found by bench/sample_orders.py, which looks for the pairs that are nets together: pixel and light, pixel and lens, all three.
constexpr Order kOfLight = {0x0001, 0x0003, 0x0004, 0x000d, 0x0011, 0x0032, 0x0045, 0x00db, 0x0114, 0x0305, 0x041f, 0x0a33, 0x1987, 0x29e5, 0x6070, 0xf927};
constexpr Order kOfLens = {0x0001, 0x0003, 0x0004, 0x000a, 0x0017, 0x002a, 0x0068, 0x00f4, 0x0116, 0x02db, 0x06e2, 0x08f9, 0x1b17, 0x31dd, 0x4000, 0x8000};

/// The sums of an order for all values of the lower and of the upper eight digits, of reversed indices.
struct OrderSums {
    std::array<uint32_t, 256> of[2];

    explicit constexpr OrderSums(const Order& order) : of{} {
        for (size_t half = 0; half < 2; ++half)
            for (size_t digits = 0; digits < 256; ++digits)
                for (size_t k = 0; k < 8; ++k)
                    if (digits >> (7 - k) & 1) of[half][digits] ^= reversed(uint32_t(order[8 * half + k]));
    }
};
constexpr OrderSums kSumsOfLight(kOfLight), kSumsOfLens(kOfLens);

uint32_t in_order(const OrderSums& sums, uint32_t reversed_index) { return (reversed_index & 0xffffu) ^ sums.of[0][reversed_index >> 24] ^ sums.of[1][reversed_index >> 16 & 0xff]; }

/// Sobol's (0, 2)-sequence for each pair of coordinates, each in an order of its own; shuffled for each order, and scrambled for each domain.
Vec2 sobol(const SampleDomain& domain, uint32_t index, uint32_t) {
    const uint64_t shuffle = domain.order.bits(0), scramble = domain.own.bits(1);
    // The index is shuffled by a scrambling, which permutes aligned blocks of 2^k, so that each stays a net. The first dimension is that index, reversed.
    uint32_t first = scrambled_from_below(reversed(index), uint32_t(shuffle));
    if (domain.coordinates != Coordinates::pixel) first = in_order(domain.coordinates == Coordinates::light ? kSumsOfLight : kSumsOfLens, first);
    return owen_scrambled(first, sobol_second(first), scramble);
}

#ifdef __x86_64__
/// The same of eight at once, a lane each: operations on whole numbers, so the same bits.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i reversed(__m256i x) {
    const __m256i bytes = _mm256_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203, 0x0c0d0e0f08090a0b, 0x0405060700010203);
    const __m256i halves = _mm256_set_epi64x(0x0f070b030d050901, 0x0e060a020c040800, 0x0f070b030d050901, 0x0e060a020c040800), four = _mm256_set1_epi8(0x0f);
    const __m256i turned = _mm256_shuffle_epi8(x, bytes), low = _mm256_shuffle_epi8(halves, turned & four), high = _mm256_shuffle_epi8(halves, _mm256_srli_epi16(turned, 4) & four);
    return _mm256_slli_epi16(low, 4) | high;
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i scrambled_from_below(__m256i x, uint32_t seed) {
    x = _mm256_add_epi32(x, _mm256_set1_epi32(int(seed)));
    for (const uint32_t k : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) x = x ^ _mm256_mullo_epi32(x, _mm256_set1_epi32(int(k)));
    return x;
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i sobol_second(__m256i first) {
    __m256i x = first ^ _mm256_slli_epi32(first, 16);
    x = x ^ _mm256_slli_epi32(x & _mm256_set1_epi32(0x00ff00ff), 8);
    x = x ^ _mm256_slli_epi32(x & _mm256_set1_epi32(0x0f0f0f0f), 4);
    x = x ^ _mm256_slli_epi32(x & _mm256_set1_epi32(0x33333333), 2);
    return x ^ _mm256_slli_epi32(x & _mm256_set1_epi32(0x55555555), 1);
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i in_order(const OrderSums& sums, __m256i reversed_index) {
    const __m256i lower = _mm256_i32gather_epi32(reinterpret_cast<const int*>(sums.of[0].data()), _mm256_srli_epi32(reversed_index, 24), 4);
    const __m256i upper = _mm256_i32gather_epi32(reinterpret_cast<const int*>(sums.of[1].data()), _mm256_srli_epi32(reversed_index, 16) & _mm256_set1_epi32(0xff), 4);
    return (reversed_index & _mm256_set1_epi32(0xffff)) ^ lower ^ upper;
}

[[gnu::target("avx2")]] void sobol_in_lanes(const SampleDomain& domain, uint32_t begin, SampleBlock& out) {
    const uint64_t shuffle = domain.order.bits(0), scramble = domain.own.bits(1);
    const __m256i index = _mm256_add_epi32(_mm256_set1_epi32(int(begin)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    __m256i first = scrambled_from_below(reversed(index), uint32_t(shuffle));
    if (domain.coordinates != Coordinates::pixel) first = in_order(domain.coordinates == Coordinates::light ? kSumsOfLight : kSumsOfLens, first);
    const __m256i second = sobol_second(first);
    alignas(32) uint32_t x[kSampleBlock], y[kSampleBlock];
    _mm256_store_si256(reinterpret_cast<__m256i*>(x), reversed(scrambled_from_below(reversed(first), uint32_t(scramble))));
    _mm256_store_si256(reinterpret_cast<__m256i*>(y), reversed(scrambled_from_below(reversed(second), uint32_t(scramble >> 32))));
    for (uint32_t i = 0; i < kSampleBlock; ++i) out[i] = {to_unit(x[i]), to_unit(y[i])};
}
#endif

void sobol_block(const SampleDomain& domain, uint32_t begin, uint32_t count, SampleBlock& out) {
#ifdef __x86_64__
    if (kHasLanes) return sobol_in_lanes(domain, begin, out);
#endif
    for (uint32_t i = 0; i < kSampleBlock; ++i) out[i] = sobol(domain, begin + i, count);
}

/// The place of `index` in a permutation of 0 .. count - 1: a Feistel network over the next power of four, walked until it lands inside.
uint32_t permuted(uint32_t index, uint32_t count, RandomKey key) {
    uint32_t half = 0;
    while ((uint64_t(1) << (2 * half)) < count) ++half;
    const uint32_t mask = (1u << half) - 1;
    do {
        uint32_t left = index >> half, right = index & mask;
        for (uint64_t round = 0; round < 4; ++round) {
            const uint32_t next = left ^ (uint32_t(key.bits((uint64_t(right) << 8) + round)) & mask);
            left = right;
            right = next;
        }
        index = (left << half) | right;
    } while (index >= count);
    return index;
}

/// A jittered grid, as nearly square as `count` allows, its cells in random order.
Vec2 stratified(const SampleDomain& domain, uint32_t index, uint32_t count) {
    uint32_t rows = uint32_t(std::sqrt(double(count)));
    while (count % rows) --rows;
    const uint32_t columns = count / rows, cell = permuted(index % count, count, domain.own.child(0));
    const RandomKey jitter = domain.own.child(1).child(index);
    return {(cell % columns + jitter.uniform(0)) / columns, (cell / columns + jitter.uniform(1)) / rows};
}

Vec2 independent(const SampleDomain& domain, uint32_t index, uint32_t) {
    const RandomKey key = domain.own.child(index);
    return {key.uniform(0), key.uniform(1)};
}

constexpr SamplerEntry kTable[] = {
    {"sobol", "low discrepancy: Sobol pairs that are spread over pixel, light and lens together, Owen-scrambled", sobol, sobol_block},
    {"stratified", "a jittered grid", stratified},
    {"random", "independent", independent},
};

}  // namespace

std::span<const SamplerEntry> samplers() { return kTable; }

const SamplerEntry* find_sampler(std::string_view name) {
    for (const SamplerEntry& e : kTable)
        if (name == e.name) return &e;
    return nullptr;
}

void sample_block(const SamplerEntry& sampler, const SampleDomain& domain, uint32_t begin, uint32_t count, SampleBlock& out) {
    if (sampler.block) return sampler.block(domain, begin, count, out);
    for (uint32_t i = 0; i < std::min(kSampleBlock, count - begin); ++i) out[i] = sampler.pair(domain, begin + i, count);
}

namespace {

/// The cosine and the sine of an angle of at most pi / 4: Taylor's series, whose next terms are below 1e-17. Without a call, since a lens asks for them with each ray.
Vec2 small_angle(double angle) {
    static constexpr std::array<double, 18> kTerms = [] {   // 1 / n!
        std::array<double, 18> terms{};
        double factorial = 1;   // below 2^53, so that none is rounded
        for (int n = 0; n < 18; ++n) terms[size_t(n)] = 1 / factorial, factorial *= n + 1;
        return terms;
    }();
    const double square = -angle * angle;
    Vec2 sum(0);
    for (size_t n = 18; n > 0; n -= 2) sum = sum * square + Vec2(kTerms[n - 2], kTerms[n - 1]);
    return {sum.x, sum.y * angle};
}

}  // namespace

Vec2 concentric_disc(const Vec2& square) {
    const double x = 2 * square.x - 1, y = 2 * square.y - 1;
    if (x == 0 && y == 0) return Vec2(0);
    const bool wide = std::abs(x) > std::abs(y);
    const double r = wide ? x : y;
    const Vec2 turned = small_angle(kPi / 4 * (wide ? y / x : x / y));   // from the x axis, or from the y axis towards x
    return wide ? turned * r : Vec2(turned.y, turned.x) * r;
}

}  // namespace alidade

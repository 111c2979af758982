// SPDX-License-Identifier: Apache-2.0
/// Boxes and triangles of the compact BVH in vectors, compiled once for each target of a file that includes it (hwy/foreach_target.h).
#if defined(ALIDADE_COMPACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_COMPACT_INL
#undef ALIDADE_COMPACT_INL
#else
#define ALIDADE_COMPACT_INL
#endif

#include "accel/bvh/compact.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many planes as `d` has lanes, from `place` on, counted from the node's first. They belong to `axis`.
template <class D, class R> HWY_INLINE HWY_ATTR hn::Vec<D> load_planes(D d, const WideNode<R>& node, int, size_t place) {
    const R* const planes = node.planes[0];
    return hn::Load(d, planes + place);
}
template <class D> HWY_INLINE HWY_ATTR hn::Vec<D> load_planes(D d, const CompactNode& node, int axis, size_t place) {
    const uint8_t* const bytes = node.steps[0];
    const auto steps = hn::PromoteTo(hn::Rebind<int32_t, D>(), hn::LoadU(hn::Rebind<uint8_t, D>(), bytes + place));
    return hn::MulAdd(hn::ConvertTo(d, steps), hn::Set(d, node.grid.step(axis)), hn::Set(d, node.grid.origin[axis]));   // fused or not: ByteGrid::plane
}

/// The triangles of a block in `lanes`, as tests of eight want them; in the other lanes there is anything.
template <class R> HWY_INLINE HWY_ATTR const TriangleBlock<R>& load_block(const PackedBlocks<R>& blocks, uint32_t number, uint32_t) { return blocks[number]; }
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// The coordinates of eight vertices, x, y and z in a vector each.
HWY_INLINE HWY_ATTR void load_vertices(const Vec3f* positions, const uint32_t* vertices, float (*xyz)[kLanes]) {
    const hn::FixedTag<float, 8> d;
    const hn::FixedTag<double, 4> pairs;
    const hn::FixedTag<float, 4> half;
    const auto three = hn::FirstN(half, 3);   // nothing behind the last vertex is read
    const auto two = [&](int lane) HWY_ATTR { return hn::Combine(d, hn::MaskedLoad(three, half, &positions[vertices[lane + 4]].x), hn::MaskedLoad(three, half, &positions[vertices[lane]].x)); };
    const auto a = two(0), b = two(1), c = two(2), e = two(3);
    const auto ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b)), ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));       // x x y y in each half
    const auto ab_z = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b)), ce_z = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));   // z z 0 0
    hn::Store(hn::BitCast(d, hn::InterleaveLower(pairs, ab, ce)), d, xyz[0]);
    hn::Store(hn::BitCast(d, hn::InterleaveUpper(pairs, ab, ce)), d, xyz[1]);
    hn::Store(hn::BitCast(d, hn::InterleaveLower(pairs, ab_z, ce_z)), d, xyz[2]);
}

/// The corners of a block that keeps them, spread over its lanes.
HWY_INLINE HWY_ATTR void load_corners(const CorneredBlock& from, TriangleBlock<float>& block) {
    const hn::FixedTag<float, 8> d;
    const hn::FixedTag<int32_t, 8> whole;
    const hn::FixedTag<uint32_t, 8> ids;
    hn::Store(hn::LoadU(ids, from.id), ids, block.id);
    const auto vertices = [&](int corner) HWY_ATTR { return hn::PromoteTo(whole, hn::Load(hn::FixedTag<uint8_t, 8>(), from.corner[corner])); };
    const auto low = [&](auto v) HWY_ATTR { return hn::IndicesFromVec(d, hn::And(v, hn::Set(whole, 7))); };
    const auto a = vertices(0), b = vertices(1), c = vertices(2);
    const auto at_a = low(a), at_b = low(b), at_c = low(c);
    if (from.vertices <= 8) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto first = hn::LoadU(d, from.coordinates(axis));
            hn::Store(hn::TableLookupLanes(first, at_a), d, block.v[axis]), hn::Store(hn::TableLookupLanes(first, at_b), d, block.v[3 + axis]), hn::Store(hn::TableLookupLanes(first, at_c), d, block.v[6 + axis]);
        }
        return;
    }
    const auto second = [&](auto v) HWY_ATTR { return hn::RebindMask(d, hn::Gt(v, hn::Set(whole, 7))); };
    const auto second_a = second(a), second_b = second(b), second_c = second(c);
    for (int axis = 0; axis < 3; ++axis) {
        const float* const coordinates = from.coordinates(axis);
        const auto low_eight = hn::LoadU(d, coordinates), high_eight = hn::LoadU(d, coordinates + 8);   // behind the last there is room
        const auto pick = [&](auto at, auto is_high) HWY_ATTR { return hn::IfThenElse(is_high, hn::TableLookupLanes(high_eight, at), hn::TableLookupLanes(low_eight, at)); };
        hn::Store(pick(at_a, second_a), d, block.v[axis]), hn::Store(pick(at_b, second_b), d, block.v[3 + axis]), hn::Store(pick(at_c, second_c), d, block.v[6 + axis]);
    }
}

/// Eight numbers of so many bits, from `list` on.
HWY_INLINE HWY_ATTR hn::Vec<hn::FixedTag<uint32_t, 8>> load_numbers(const uint8_t* list, uint32_t bits) {
    const hn::FixedTag<uint32_t, 8> d;
    const hn::FixedTag<uint8_t, 32> bytes;
    const hn::FixedTag<uint8_t, 16> half;
    if (bits == SteppedBlock::kWhole) [[unlikely]] return hn::LoadU(d, reinterpret_cast<const uint32_t*>(list));
    const BitLanes& lanes = kBitLanes[bits];
    const auto read = hn::Combine(bytes, hn::LoadU(half, list + bits / 2), hn::LoadU(half, list));
    const auto words = hn::BitCast(d, hn::TableLookupBytes(read, hn::Load(bytes, lanes.bytes[0])));
    return hn::And(hn::Shr(words, hn::Load(d, lanes.shift)), hn::Set(d, (1u << bits) - 1));
}

/// The corners of a block that keeps them in steps.
HWY_INLINE HWY_ATTR void load_corners(const SteppedBlock& from, TriangleBlock<float>& block) {
    const hn::FixedTag<float, 8> d;
    const hn::FixedTag<int32_t, 8> whole;
    const uint8_t* list = from.list(0, 0);
    __builtin_prefetch(list + 192);
    for (int axis = 0; axis < 3; ++axis) {
        const uint32_t bits = from.bits[axis];
        const size_t bytes = from.list_bytes(size_t(axis));
        const auto step = hn::Set(d, from.grid.step(axis)), origin = hn::Set(d, from.grid.origin[axis]);
        for (int corner = 0; corner < 3; ++corner, list += bytes) {
            if (bits == SteppedBlock::kWhole) [[unlikely]] hn::Store(hn::LoadU(d, reinterpret_cast<const float*>(list)), d, block.v[3 * corner + axis]);
            else hn::Store(hn::MulAdd(hn::ConvertTo(d, hn::BitCast(whole, load_numbers(list, bits))), step, origin), d, block.v[3 * corner + axis]);
        }
    }
    hn::Store(load_numbers(list, from.bits[3]), hn::FixedTag<uint32_t, 8>(), block.id);
}

/// So few are read one by one.
inline constexpr int kFewLanes = 3;

HWY_INLINE HWY_ATTR TriangleBlock<float> load_block(const NumberedBlocks& blocks, uint32_t number, uint32_t lanes) {
    TriangleBlock<float> block;
    if (!blocks.has_boxes(number)) {
        if (blocks.is_stepped(number)) load_corners(blocks.stepped(number), block);
        else load_corners(blocks.cornered(number), block);
        return block;
    }
    const uint32_t* const ids = blocks.boxes(number).child;
    const Index3* const triangles = blocks.mesh().triangles.data();
    if (std::popcount(lanes) <= kFewLanes) {
        for (; lanes; lanes &= lanes - 1) {
            const auto lane = uint32_t(std::countr_zero(lanes)), id = ids[lane];
            const Index3& t = triangles[id];
            block.id[lane] = id;
            for (int corner = 0; corner < 3; ++corner) {
                const Vec3f& p = blocks.mesh().positions[size_t(t[corner])];
                block.v[3 * corner][lane] = p.x, block.v[3 * corner + 1][lane] = p.y, block.v[3 * corner + 2][lane] = p.z;
            }
        }
        return block;
    }
    const auto first = uint32_t(std::countr_zero(lanes));   // is in the other lanes, too: it is read anyway
    uint32_t vertices[3][kLanes];
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const uint32_t id = ids[lanes >> lane & 1 ? lane : first];
        const Index3& t = triangles[id];
        vertices[0][lane] = t.x, vertices[1][lane] = t.y, vertices[2][lane] = t.z, block.id[lane] = id;
    }
    for (int corner = 0; corner < 3; ++corner) load_vertices(blocks.mesh().positions.data(), vertices[corner], &block.v[3 * corner]);
    return block;
}
#else
HWY_INLINE HWY_ATTR TriangleBlock<float> load_block(const NumberedBlocks& blocks, uint32_t number, uint32_t lanes) { return blocks.block(number, lanes); }
#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

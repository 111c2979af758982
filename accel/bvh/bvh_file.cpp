// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/bvh_file.h"

#include "accel/bvh/wide_nodes.h"
#include "accel/load.h"
#include "core/fingerprint.h"
#include "core/mapped_file.h"
#include "core/output_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace alidade {
namespace {

constexpr std::array<char, 8> kMagic{'A', 'L', 'I', 'D', 'B', 'V', 'H', '\n'};
constexpr uint32_t kVersion = 1, kByteOrder = 0x01020304;
constexpr size_t kAlignment = 64;   // of nodes and blocks, in the file as in memory

/// What a file begins with. Nodes, blocks of triangles and the numbers of those removed follow, filled up with zeros to kAlignment.
struct Head {
    std::array<char, 8> magic = kMagic;
    uint32_t version = kVersion, byte_order = kByteOrder, real_bytes = 0, lanes = kLanes, node_bytes = 0, block_bytes = 0;
    uint64_t file_bytes = 0, checksum = 0, mesh = 0;
    uint64_t nodes = 0, blocks = 0, removed = 0, splits = 0, split_candidates = 0;
    double sah_cost = 0, bounds[6] = {};
    uint64_t watertight = 0;   ///< 1: boxes are those of make_watertight()
    uint64_t later[12] = {};
};
static_assert(sizeof(Head) == 256 && std::is_trivially_copyable_v<Head>);

constexpr size_t filled_up(size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }
size_t file_size(const Head& head) { return sizeof(Head) + head.nodes * head.node_bytes + head.blocks * head.block_bytes + filled_up(head.removed * sizeof(uint32_t)); }

using Bytes = std::span<const std::byte>;
template <class T> Bytes bytes_of(const T& value) { return std::as_bytes(std::span(&value, 1)); }

/// Of the head without its checksum, and of what follows it.
uint64_t checksum(Head head, Bytes nodes, Bytes blocks, Bytes removed) {
    head.checksum = 0;
    uint64_t sum = fingerprint_of_array(bytes_of(head));
    for (const Bytes part : {nodes, blocks, removed}) sum = fingerprint_of_array(part, sum);
    return sum;
}

/// Why this is no file of this version for this machine, precision and mesh, or "".
template <class R> std::string why_another(const Head& head, size_t bytes, const TriangleView& mesh) {
    constexpr uint64_t most = uint64_t(1) << 32;   // so that sizes do not overflow
    if (head.magic != kMagic) return "it holds no BVH";
    if (head.byte_order != kByteOrder) return "it was written by a machine with another order of bytes";
    if (head.version != kVersion) return "it has version " + std::to_string(head.version) + ", this program reads " + std::to_string(kVersion);
    if (head.real_bytes != sizeof(R)) return head.real_bytes == 4 ? "its numbers are float, asked for are double" : "its numbers are double, asked for are float";
    if (head.lanes != kLanes || head.node_bytes != sizeof(WideNode<R>) || head.block_bytes != sizeof(TriangleBlock<R>)) return "its nodes or leaves are not of this program's shape";
    if (head.nodes >= most || head.blocks >= most || head.removed >= most || head.file_bytes != file_size(head)) return "its head contradicts itself";
    if (head.file_bytes != bytes) return "it has " + std::to_string(bytes) + " bytes of " + std::to_string(head.file_bytes);
    if (head.mesh != mesh_fingerprint(mesh, sizeof(R) == sizeof(float) ? Precision::float_ : Precision::double_)) return "it was built over other triangles";
    return {};
}

/// Looks at everything once: a file may have the right checksum, and yet be made to lead a ray astray.
template <class R> class Inspector {
  public:
    Inspector(std::span<const WideNode<R>> nodes, std::span<const TriangleBlock<R>> blocks, const TriangleView& mesh)
        : nodes_(nodes), blocks_(blocks), mesh_(mesh), source_(mesh), depths_(nodes.size(), kUnseen), packed_(blocks.size()), placed_(mesh.triangles.size()) {}

    /// Is it a tree of all triangles but those in `stats`.removed? Fills in what `stats` counts.
    bool is_sound(BuildStats& stats) {
        if (stats.removed.size() > placed_.size()) return false;
        for (const uint32_t id : stats.removed)
            if (id >= placed_.size()) return false;
        if (!nodes_.empty()) depths_[0] = 0;
        for (uint32_t n = 0; n < nodes_.size(); ++n)
            if (!is_node_sound(n)) return false;
        stats.nodes = nodes_.size(), stats.leaves = leaves_, stats.references = references_, stats.primitives = placed_.size() - stats.removed.size(), stats.depth = deepest_;
        for (const uint32_t id : stats.removed)
            if (std::exchange(placed_[id], uint8_t(1))) return false;
        return leaves_ == blocks_.size() && std::find(placed_.begin(), placed_.end(), 0) == placed_.end();
    }

  private:
    static constexpr uint8_t kUnseen = 255;
    static_assert(kBvhDepth < kUnseen);

    /// Children come behind their parents, so that there are no circles, each once, and no deeper than a ray's stack.
    bool is_node_sound(uint32_t n) {
        if (depths_[n] == kUnseen) return false;
        deepest_ = std::max(deepest_, size_t(depths_[n]));
        for (uint32_t i = 0; i < kWide; ++i) {
            const uint32_t child = nodes_[n].child[i];
            const BoundsT<R> box = box_at(nodes_[n], i);
            if (vacant(nodes_[n], i) && -box.min == box.max && box.max == Vec3T<R>(-std::numeric_limits<R>::infinity())) continue;
            if (box.empty() || !box.finite()) return false;
            if (WideLeaf::is(child) ? !is_leaf_sound(WideLeaf::block(child), WideLeaf::count(child)) : !is_child_sound(n, child)) return false;
        }
        return true;
    }
    bool is_child_sound(uint32_t parent, uint32_t child) {
        if (child <= parent || child >= nodes_.size() || depths_[child] != kUnseen || depths_[parent] + 1u >= kBvhDepth) return false;
        depths_[child] = uint8_t(depths_[parent] + 1);
        return true;
    }
    bool is_leaf_sound(uint32_t block, uint32_t count) {
        if (block >= blocks_.size() || std::exchange(packed_[block], uint8_t(1))) return false;
        ++leaves_, references_ += count;
        for (uint32_t lane = 0; lane < count; ++lane)
            if (!is_triangle_sound(blocks_[block], lane)) return false;
        return true;
    }
    /// It is the mesh's.
    bool is_triangle_sound(const TriangleBlock<R>& block, uint32_t lane) {
        const uint32_t id = block.id[lane];
        if (id >= placed_.size() || std::max({mesh_.triangles[id].x, mesh_.triangles[id].y, mesh_.triangles[id].z}) >= mesh_.positions.size()) return false;
        placed_[id] = 1;
        const Corners held = block.corners(lane), given = source_.corners(id);
        for (size_t k = 0; k < 3; ++k)
            if (held[k] != given[k] || !(max_abs(held[k]) <= kLargestCoordinate<R>)) return false;
        return true;
    }

    std::span<const WideNode<R>> nodes_;
    std::span<const TriangleBlock<R>> blocks_;
    const TriangleView& mesh_;
    TriangleSource<R> source_;
    std::vector<uint8_t> depths_, packed_, placed_;   ///< the last two: 1 where it has been met
    size_t leaves_ = 0, references_ = 0, deepest_ = 0;
};

template <class T> std::span<const T> part_of(Bytes bytes, size_t at, size_t count) { return {reinterpret_cast<const T*>(bytes.data() + at), count}; }

}  // namespace

uint64_t mesh_fingerprint(const TriangleView& mesh, Precision precision) {
    const bool exact = precision == Precision::double_ && mesh.exact_positions.size() == mesh.positions.size();
    return fingerprint_of_array(exact ? std::as_bytes(mesh.exact_positions) : std::as_bytes(mesh.positions), fingerprint_of_array(std::as_bytes(mesh.triangles)));
}

template <class R>
tl::expected<void, std::string> save_bvh(const std::string& path, const TriangleView& mesh, std::span<const WideNode<R>> nodes, std::span<const TriangleBlock<R>> blocks, const Bounds& bounds, const BuildStats& stats, bool watertight) {
    std::vector<uint32_t> removed = stats.removed;
    removed.resize(filled_up(removed.size() * sizeof(uint32_t)) / sizeof(uint32_t));
    Head head;
    head.real_bytes = sizeof(R), head.node_bytes = sizeof(WideNode<R>), head.block_bytes = sizeof(TriangleBlock<R>);
    head.nodes = nodes.size(), head.blocks = blocks.size(), head.removed = stats.removed.size(), head.splits = stats.splits, head.split_candidates = stats.split_candidates, head.sah_cost = stats.sah_cost, head.watertight = watertight;
    for (int a = 0; a < 3; ++a) head.bounds[a] = bounds.min[a], head.bounds[3 + a] = bounds.max[a];
    head.mesh = mesh_fingerprint(mesh, sizeof(R) == sizeof(float) ? Precision::float_ : Precision::double_);
    head.file_bytes = file_size(head);
    head.checksum = checksum(head, std::as_bytes(nodes), std::as_bytes(blocks), std::as_bytes(std::span(removed)));
    OutputFile file(path);
    for (const Bytes part : {bytes_of(head), std::as_bytes(nodes), std::as_bytes(blocks), std::as_bytes(std::span(removed))}) file.write(part);
    return file.finish();
}

template <class R> tl::expected<BvhParts<R>, std::string> load_bvh(const std::string& path, const TriangleView& mesh) {
    const auto failure = [&](const std::string& why) { return tl::unexpected("cannot use " + path + ": " + why); };
    const auto file = MappedFile::open(path);
    if (!file) return tl::unexpected(file.error());
    const Bytes bytes = (*file)->bytes();
    Head head;
    if (bytes.size() < sizeof(Head)) return failure("it holds no BVH");
    std::memcpy(&head, bytes.data(), sizeof(Head));
    if (const std::string why = why_another<R>(head, bytes.size(), mesh); !why.empty()) return failure(why);
    const size_t blocks_at = sizeof(Head) + head.nodes * head.node_bytes, removed_at = blocks_at + head.blocks * head.block_bytes;
    if (head.checksum != checksum(head, bytes.subspan(sizeof(Head), blocks_at - sizeof(Head)), bytes.subspan(blocks_at, removed_at - blocks_at), bytes.subspan(removed_at))) return failure("it is damaged: its checksum is another");
    const auto nodes = part_of<WideNode<R>>(bytes, sizeof(Head), head.nodes);
    const auto blocks = part_of<TriangleBlock<R>>(bytes, blocks_at, head.blocks);
    const auto removed = part_of<uint32_t>(bytes, removed_at, head.removed);
    BvhParts<R> parts{{nodes, *file}, {blocks, *file}, {{head.bounds[0], head.bounds[1], head.bounds[2]}, {head.bounds[3], head.bounds[4], head.bounds[5]}}, {}, head.watertight != 0};
    parts.stats.removed.assign(removed.begin(), removed.end());
    parts.stats.splits = head.splits, parts.stats.split_candidates = head.split_candidates, parts.stats.sah_cost = head.sah_cost;
    const bool bounded = nodes.empty() ? parts.bounds.empty() : !parts.bounds.empty() && parts.bounds.finite();
    if (!bounded || !Inspector<R>(nodes, blocks, mesh).is_sound(parts.stats)) return failure("its numbers are no tree over the triangles");
    return parts;
}

template tl::expected<void, std::string> save_bvh(const std::string&, const TriangleView&, std::span<const WideNode<float>>, std::span<const TriangleBlock<float>>, const Bounds&, const BuildStats&, bool);
template tl::expected<void, std::string> save_bvh(const std::string&, const TriangleView&, std::span<const WideNode<double>>, std::span<const TriangleBlock<double>>, const Bounds&, const BuildStats&, bool);
template tl::expected<BvhParts<float>, std::string> load_bvh(const std::string&, const TriangleView&);
template tl::expected<BvhParts<double>, std::string> load_bvh(const std::string&, const TriangleView&);

}  // namespace alidade

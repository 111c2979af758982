// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/bvh.h"

#include "accel/load.h"
#include "accel/structure.h"

namespace alidade {

namespace {

template <class R, TriangleTest test> std::unique_ptr<Accelerator> over_parts(BvhParts<R> parts, const AccelOptions& options) {
    using Leaf = TriangleLeaf<R, test>;
    if (is_watertight<Leaf> && !parts.watertight) {
        make_watertight(parts.nodes.writable(), options.threads, parts.blocks.view());
        parts.watertight = true;
    }
    return std::make_unique<StructureAccelerator<Bvh, Leaf>>(Bvh<Leaf>(std::move(parts.nodes), parts.watertight, options), Leaf(PackedBlocks<R>(std::move(parts.blocks)), options), parts.bounds, std::move(parts.stats));
}

template <class R> tl::expected<std::unique_ptr<Accelerator>, std::string> load(const std::string& path, const TriangleView& mesh, const AccelOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    auto parts = load_bvh<R>(path, mesh);
    if (!parts) return tl::unexpected(parts.error());
    parts->stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    parts->stats.phases = {{"map", parts->stats.seconds}};
    switch (options.intersect) {
        case Intersect::exact: break;
        case Intersect::robust: return over_parts<R, TriangleTest::watertight>(std::move(*parts), options);
        case Intersect::fast: return over_parts<R, TriangleTest::fast>(std::move(*parts), options);
    }
    return over_parts<R, TriangleTest::exact>(std::move(*parts), options);
}

}  // namespace

tl::expected<std::unique_ptr<Accelerator>, std::string> load_accelerator(const std::string& path, const TriangleView& mesh, const AccelOptions& options) {
    return options.precision == Precision::double_ ? load<double>(path, mesh, options) : load<float>(path, mesh, options);
}

template std::unique_ptr<Accelerator> over_triangles<Bvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<Bvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

template std::unique_ptr<Accelerator> over_triangles<FastBvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<FastBvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

template std::unique_ptr<Accelerator> over_triangles<CompactBvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<CompactBvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

}  // namespace alidade

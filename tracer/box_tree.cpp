// SPDX-License-Identifier: Apache-2.0
#include "tracer/box_tree.h"

#include <algorithm>
#include <numeric>

namespace alidade {
namespace {

/// Twice where the middle is.
double center(const Bounds& box, int axis) { return box.min[axis] + box.max[axis]; }

int widest_axis(std::span<const Bounds> boxes, std::span<const uint32_t> numbers) {
    Bounds centers;
    for (const uint32_t i : numbers) centers.extend(Vec3(center(boxes[i], 0), center(boxes[i], 1), center(boxes[i], 2)));
    const Vec3 e = centers.extent();
    return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes) {
    std::vector<uint32_t> numbers(boxes.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    // Boxes without an end would make nodes of everything: they stand before the tree of the others.
    const auto ends = std::stable_partition(numbers.begin(), numbers.end(), [&](uint32_t i) { return !boxes[i].finite(); });
    nodes_.reserve(2 * boxes.size());
    for (auto i = numbers.begin(); i != ends; ++i) add(boxes, {&*i, 1});
    if (ends != numbers.end()) add(boxes, {ends, numbers.end()});
}

void BoxTree::add(std::span<const Bounds> boxes, std::span<uint32_t> numbers) {
    const size_t n = nodes_.size();
    nodes_.emplace_back();
    for (const uint32_t i : numbers) nodes_[n].bounds.extend(boxes[i]);
    if (numbers.size() == 1) {
        nodes_[n].box = numbers[0];
    } else {
        const int axis = widest_axis(boxes, numbers);
        const size_t half = numbers.size() / 2;
        std::nth_element(numbers.begin(), numbers.begin() + std::ptrdiff_t(half), numbers.end(), [&](uint32_t a, uint32_t b) { return center(boxes[a], axis) < center(boxes[b], axis); });
        add(boxes, numbers.first(half)), add(boxes, numbers.subspan(half));
    }
    nodes_[n].next = uint32_t(nodes_.size());
}

}  // namespace alidade

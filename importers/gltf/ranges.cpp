// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/ranges.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

/// Bytes that accessors without a buffer view may claim together.
constexpr uint64_t kMaxUnbackedBytes = uint64_t(1) << 28;

struct TypeRow {
    const char* name;
    uint32_t columns, rows;
};
constexpr TypeRow kTypes[] = {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}};

class RangeChecker {
  public:
    RangeChecker(const Json& root, Reporter& report) : root_(root), report_(report) {}

    void check_view(size_t index) {
        const Json& view = root_["bufferViews"][index];
        const uint64_t size = whole(root_["buffers"][view["buffer"].get<size_t>()], "byteLength"), end = whole(view, "byteOffset") + whole(view, "byteLength");
        if (end > size) report_.error(child("/bufferViews", index), fmt::format("ends at byte {}, but its buffer has {} bytes", end, size));
    }

    void check_accessor(size_t index) {
        const Json& accessor = root_["accessors"][index];
        const std::string at = child("/accessors", index);
        const ElementLayout layout = layout_of(accessor);
        for (const char* bound : {"min", "max"}) {
            if (accessor.contains(bound) && accessor[bound].size() != layout.components())
                report_.error(child(at, bound), fmt::format("has {} elements, but {} has {}", accessor[bound].size(),
                                                            accessor["type"].get_ref<const std::string&>(), layout.components()));
        }
        if (accessor.contains("bufferView")) check_elements(accessor, layout, whole(accessor, "count"), at, true);
        if (accessor.contains("sparse")) check_sparse(accessor["sparse"], layout, whole(accessor, "count"), child(at, "sparse"));
    }

  private:
    /// `count` elements of `element_bytes` at the bufferView and byteOffset of `place`. No product here overflows: check_schema() has
    /// limited every number to 2^53, and a stride to 252.
    void check_elements(const Json& place, const ElementLayout& layout, uint64_t count, const std::string& at, bool strided) {
        const Json& view = root_["bufferViews"][place["bufferView"].get<size_t>()];
        const uint64_t given = strided ? whole(view, "byteStride") : 0, stride = given ? given : layout.stride(), element_bytes = layout.bytes();
        if (stride < element_bytes)
            return report_.error(at, fmt::format("the elements have {} bytes, but the byteStride of their view is {}", element_bytes, stride));
        const uint64_t offset = whole(place, "byteOffset"), length = whole(view, "byteLength");
        if (offset > length || (count - 1) * stride + element_bytes > length - offset) {
            report_.error(at, fmt::format("{} elements of {} bytes at offset {} do not fit into their buffer view of {} bytes", count, element_bytes,
                                          offset, length));
        }
        if ((offset + whole(view, "byteOffset")) % layout.component_bytes != 0)
            report_.warning(at, fmt::format("the elements are not aligned to {} bytes", layout.component_bytes));
    }

    void check_sparse(const Json& sparse, const ElementLayout& layout, uint64_t accessor_count, const std::string& at) {
        const uint64_t count = whole(sparse, "count");
        if (count > accessor_count) {
            return report_.error(child(at, "count"),
                                 fmt::format("{} sparse values are more than the {} elements of the accessor", count, accessor_count));
        }
        const ElementLayout index = element_layout(sparse["indices"]["componentType"].get<int>(), 1, 1);
        check_elements(sparse["indices"], index, count, child(at, "indices"), false);
        check_elements(sparse["values"], layout, count, child(at, "values"), false);
    }

    const Json& root_;
    Reporter& report_;
};

size_t size_of_array(const Json& root, const char* name) {
    const auto it = root.find(name);
    return it == root.end() ? 0 : it->size();
}

}  // namespace

ElementLayout element_layout(int component_type, uint32_t columns, uint32_t rows) {
    ElementLayout out;
    out.component_bytes = component_type <= 5121 ? 1 : component_type <= 5123 ? 2 : 4;
    out.columns = columns, out.rows = rows;
    const uint32_t bytes = rows * out.component_bytes;
    out.column_bytes = columns == 1 ? bytes : (bytes + 3) / 4 * 4;
    return out;
}

ElementLayout layout_of(const Json& accessor) {
    const auto& type = accessor["type"].get_ref<const std::string&>();
    const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const TypeRow& r) { return type == r.name; });
    return element_layout(accessor["componentType"].get<int>(), row->columns, row->rows);
}

void check_ranges(const Json& root, Reporter& report) {
    RangeChecker checker(root, report);
    for (size_t i = 0; i < size_of_array(root, "bufferViews"); ++i) checker.check_view(i);
    for (size_t i = 0; i < size_of_array(root, "accessors"); ++i) checker.check_accessor(i);
}

void materialise_zeros(Json& root, std::vector<Bytes>& buffers, Reporter& report) {
    uint64_t claimed = 0, largest = 0;
    std::vector<size_t> unbacked;
    for (size_t i = 0; i < size_of_array(root, "accessors"); ++i) {
        const Json& accessor = root["accessors"][i];
        if (accessor.contains("bufferView")) continue;
        const ElementLayout layout = layout_of(accessor);
        const uint64_t count = whole(accessor, "count");
        const uint64_t bytes = count > kMaxUnbackedBytes ? kMaxUnbackedBytes + 1 : count * layout.stride();
        claimed += bytes;
        if (claimed > kMaxUnbackedBytes) {
            return report.error(child("/accessors", i),
                                fmt::format("accessors without a buffer view claim more than {} MiB of zeros", kMaxUnbackedBytes >> 20));
        }
        largest = std::max(largest, bytes);
        unbacked.push_back(i);
    }
    if (unbacked.empty()) return;
    const size_t view = size_of_array(root, "bufferViews");
    root["buffers"].push_back({{"byteLength", largest}});
    root["bufferViews"].push_back({{"buffer", buffers.size()}, {"byteLength", largest}});
    buffers.emplace_back(largest);
    for (const size_t i : unbacked) root["accessors"][i]["bufferView"] = view, root["accessors"][i]["byteOffset"] = 0;
}

}  // namespace alidade::gltf

// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/accessors.h"

#include "importers/gltf/ranges.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

/// Component values that a file may have for each byte of its buffers, and in any case.
constexpr uint64_t kReuse = 16, kFreeComponents = uint64_t(1) << 26;

ElementLayout layout_of_accessor(const tinygltf::Accessor& accessor) {
    switch (accessor.type) {
        case TINYGLTF_TYPE_VEC2: return element_layout(accessor.componentType, 1, 2);
        case TINYGLTF_TYPE_VEC3: return element_layout(accessor.componentType, 1, 3);
        case TINYGLTF_TYPE_VEC4: return element_layout(accessor.componentType, 1, 4);
        case TINYGLTF_TYPE_MAT2: return element_layout(accessor.componentType, 2, 2);
        case TINYGLTF_TYPE_MAT3: return element_layout(accessor.componentType, 3, 3);
        case TINYGLTF_TYPE_MAT4: return element_layout(accessor.componentType, 4, 4);
        default: return element_layout(accessor.componentType, 1, 1);
    }
}

const unsigned char* bytes_at(const Model& model, int view, size_t offset) {
    const tinygltf::BufferView& v = model.bufferViews[size_t(view)];
    return model.buffers[size_t(v.buffer)].data.data() + v.byteOffset + offset;
}

template <class T> T load(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);   // elements may be misaligned
    return value;
}

/// The value of a normalised integer (glTF 2.0 specification, section 3.6.2.2 "Accessor Data Types").
template <class T> float normalised(T value) { return std::max(float(double(value) / double(std::numeric_limits<T>::max())), -1.0f); }

constexpr size_t kSkip = ~size_t(0);

/// Elements `source(i)` of the array at `from`, whose elements are `stride` bytes apart; each goes to out + place(i) * components.
template <class T, class Out, class Source, class Place>
void decode(const unsigned char* from, size_t count, size_t stride, const ElementLayout& layout, bool normalise, Out* out, Source source,
            Place place) {
    for (size_t i = 0; i < count; ++i) {
        const size_t at = place(i);
        if (at == kSkip) continue;
        const unsigned char* element = from + source(i) * stride;
        for (uint32_t c = 0; c < layout.components(); ++c) {
            const T value = load<T>(element + layout.offset(c));
            Out& to = out[at * layout.components() + c];
            if constexpr (std::is_integral_v<T> && std::is_floating_point_v<Out>) to = normalise ? Out(normalised(value)) : Out(value);
            else to = Out(value);
        }
    }
}

template <class Out, class Source, class Place>
void decode(const unsigned char* from, size_t count, size_t stride, const tinygltf::Accessor& accessor, Out* out, Source source, Place place) {
    const ElementLayout layout = layout_of_accessor(accessor);
    const bool n = accessor.normalized;
    switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return decode<int8_t>(from, count, stride, layout, n, out, source, place);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return decode<uint8_t>(from, count, stride, layout, n, out, source, place);
        case TINYGLTF_COMPONENT_TYPE_SHORT: return decode<int16_t>(from, count, stride, layout, n, out, source, place);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return decode<uint16_t>(from, count, stride, layout, n, out, source, place);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return decode<uint32_t>(from, count, stride, layout, n, out, source, place);
        default:
            if constexpr (std::is_floating_point_v<Out>) decode<float>(from, count, stride, layout, n, out, source, place);
    }
}

constexpr auto kInOrder = [](size_t i) { return i; };

std::vector<uint32_t> sparse_indices(const Model& model, const tinygltf::Accessor& accessor) {
    tinygltf::Accessor indices;
    indices.type = TINYGLTF_TYPE_SCALAR;
    indices.componentType = accessor.sparse.indices.componentType;
    indices.normalized = false;
    std::vector<uint32_t> out(size_t(accessor.sparse.count));
    const auto* from = bytes_at(model, accessor.sparse.indices.bufferView, size_t(accessor.sparse.indices.byteOffset));
    decode(from, out.size(), layout_of_accessor(indices).stride(), indices, out.data(), kInOrder, kInOrder);
    return out;
}

template <class Out> std::vector<Out> read(const Model& model, int index, std::span<const uint32_t> which) {
    const tinygltf::Accessor& accessor = model.accessors[size_t(index)];
    const ElementLayout layout = layout_of_accessor(accessor);
    const size_t given = model.bufferViews[size_t(accessor.bufferView)].byteStride, stride = given ? given : layout.stride();
    const size_t count = which.empty() ? accessor.count : which.size();
    std::vector<Out> out(count * layout.components());
    const auto* from = bytes_at(model, accessor.bufferView, accessor.byteOffset);
    if (which.empty()) decode(from, count, stride, accessor, out.data(), kInOrder, kInOrder);
    else decode(from, count, stride, accessor, out.data(), [&](size_t i) { return which[i]; }, kInOrder);
    if (!accessor.sparse.isSparse) return out;
    const std::vector<uint32_t> changed = sparse_indices(model, accessor);
    const auto* values = bytes_at(model, accessor.sparse.values.bufferView, size_t(accessor.sparse.values.byteOffset));
    decode(values, changed.size(), layout.stride(), accessor, out.data(), kInOrder, [&](size_t i) -> size_t {
        if (which.empty()) return changed[i];
        const auto found = std::lower_bound(which.begin(), which.end(), changed[i]);
        return found != which.end() && *found == changed[i] ? size_t(found - which.begin()) : kSkip;
    });
    return out;
}

/// Are the places of the sparse values increasing, and all of them inside?
bool check_sparse(const Model& model, const tinygltf::Accessor& accessor, const std::string& at, Reporter& report) {
    const std::vector<uint32_t> where = sparse_indices(model, accessor);
    for (size_t i = 0; i < where.size(); ++i) {
        if (where[i] >= accessor.count) {
            report.error(at, fmt::format("sparse index {} is {}, but the accessor has {} elements", i, where[i], accessor.count));
            return false;
        }
        if (i > 0 && where[i] <= where[i - 1]) {
            report.error(at, fmt::format("sparse index {} is {}, after {}: they must increase", i, where[i], where[i - 1]));
            return false;
        }
    }
    return true;
}

void check_finite(const Model& model, size_t index, const std::string& at, Reporter& report) {
    const std::vector<float> values = read_floats(model, int(index));
    const auto bad = std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
    if (bad == values.end()) return;
    const size_t element = size_t(bad - values.begin()) / component_count(model.accessors[index]);
    report.error(at, fmt::format("element {} is {}", element, std::isnan(*bad) ? "not a number" : "infinite"));
}

}  // namespace

uint32_t component_count(const tinygltf::Accessor& accessor) { return layout_of_accessor(accessor).components(); }

std::vector<float> read_floats(const Model& model, int accessor, std::span<const uint32_t> which) { return read<float>(model, accessor, which); }

std::vector<uint32_t> read_integers(const Model& model, int accessor, std::span<const uint32_t> which) {
    return read<uint32_t>(model, accessor, which);
}

ReadBudget::ReadBudget(const Model& model) : left_(kFreeComponents) {
    for (const tinygltf::Buffer& b : model.buffers) left_ += kReuse * b.data.size();
}

bool ReadBudget::spend(uint64_t components, const std::string& at, Reporter& report) {
    if (components > left_) {
        report.error(at, "the accessors that are read here and before hold far more numbers than the buffers that they are in");
        return false;
    }
    left_ -= components;
    return true;
}

void check_accessor_data(const Model& model, Reporter& report) {
    ReadBudget budget(model);
    for (size_t i = 0; i < model.accessors.size(); ++i) {
        const tinygltf::Accessor& accessor = model.accessors[i];
        const std::string at = child("/accessors", i);
        if (!budget.spend(accessor.count * component_count(accessor), at, report)) return;
        if (accessor.sparse.isSparse && !check_sparse(model, accessor, at, report)) continue;
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) check_finite(model, i, at, report);
    }
}

}  // namespace alidade::gltf

// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/draco.h"

#include "importers/gltf/draco_sizes.h"
#include "importers/gltf/ranges.h"

#include <cstring>
#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

constexpr const char* kName = "KHR_draco_mesh_compression";
constexpr uint64_t kFacesPerByte = 64, kFreeFaces = uint64_t(1) << 20;
constexpr int kTriangles = 4, kTriangleStrip = 5, kUnsignedInt = 5125;

/// A primitive, and where its extension stands.
struct Compressed {
    Json* primitive = nullptr;
    std::string at;
    const Json& extension() const { return (*primitive)["extensions"][kName]; }
    bool is_strip() const { return primitive->value("mode", kTriangles) == kTriangleStrip; }
};

/// All values of `attribute`, point by point, as `components` numbers of type T; false if one does not fit.
template <class T> bool copy_values(const draco::PointAttribute& attribute, uint32_t points, uint32_t components, Bytes& out) {
    const size_t first = out.size(), step = components * sizeof(T);
    out.resize(first + points * step);
    T value[4];
    for (uint32_t p = 0; p < points; ++p) {
        if (!attribute.ConvertValue<T>(attribute.mapped_index(draco::PointIndex(p)), int8_t(components), value)) return false;
        std::memcpy(out.data() + first + p * step, value, step);
    }
    return true;
}

bool copy_values(int component_type, const draco::PointAttribute& attribute, uint32_t points, uint32_t components, Bytes& out) {
    switch (component_type) {
        case 5120: return copy_values<int8_t>(attribute, points, components, out);
        case 5121: return copy_values<uint8_t>(attribute, points, components, out);
        case 5122: return copy_values<int16_t>(attribute, points, components, out);
        case 5123: return copy_values<uint16_t>(attribute, points, components, out);
        case 5125: return copy_values<uint32_t>(attribute, points, components, out);
        default: return copy_values<float>(attribute, points, components, out);
    }
}

class Decompressor {
  public:
    Decompressor(Json& root, std::vector<Bytes>& buffers, Reporter& report) : root_(root), buffers_(buffers), report_(report) {
        for (const Bytes& b : buffers) faces_left_ += kFacesPerByte * b.size();
    }

    /// Primitives that share their data are decoded once.
    void decompress(size_t view, const std::vector<Compressed>& primitives) {
        for (const Compressed& p : primitives)
            if (!check(p, view)) return;
        const auto mesh = decode(view, primitives.front().at);
        if (!mesh) return;
        out_.clear();
        for (const Compressed& p : primitives)
            if (!place_attributes(p, view, *mesh) || !place_indices(p, view, *mesh)) return;
        root_["buffers"].push_back({{"byteLength", out_.size()}});
        buffers_.push_back(std::move(out_));
    }

  private:
    bool refuse(const std::string& at, std::string message) {
        report_.error(at, std::move(message));
        return false;
    }

    std::span<const unsigned char> bytes_of(size_t view_index) const {
        const Json& view = root_["bufferViews"][view_index];
        const Bytes& buffer = buffers_[view["buffer"].get<size_t>()];
        return {buffer.data() + view.value("byteOffset", uint64_t(0)), view["byteLength"].get<size_t>()};
    }

    uint64_t count_of(const Json& accessor) const { return root_["accessors"][accessor.get<size_t>()]["count"].get<uint64_t>(); }

    /// Does the primitive claim what its data claim, and could they hold that?
    bool check(const Compressed& p, size_t view) {
        const int mode = p.primitive->value("mode", kTriangles);
        if (mode != kTriangles && mode != kTriangleStrip) return refuse(p.at, "only triangles and triangle strips can be compressed");
        const auto sizes = draco_sizes(bytes_of(view));
        if (!sizes) return refuse(p.at, sizes.error());
        const auto indices = p.primitive->find("indices");
        if (!p.is_strip() && indices != p.primitive->end() && count_of(*indices) != 3 * sizes->faces)
            return refuse(p.at, fmt::format("the accessor of the indices has {} elements, but {} triangles are compressed", count_of(*indices), sizes->faces));
        for (const auto& [name, id] : p.extension()["attributes"].items()) {
            const auto accessor = (*p.primitive)["attributes"].find(name);
            if (accessor == (*p.primitive)["attributes"].end()) report_.warning(child(child(p.at, "attributes"), name), "the primitive has no such attribute");
            else if (count_of(*accessor) < sizes->points) return wrong_count(p, name, count_of(*accessor), sizes->points);
        }
        return true;
    }

    bool wrong_count(const Compressed& p, const std::string& name, uint64_t wanted, uint64_t points) {
        return refuse(child(child(p.at, "attributes"), name), fmt::format("the accessor has {} elements, but {} vertices are compressed", wanted, points));
    }

    std::unique_ptr<draco::Mesh> decode(size_t view, const std::string& at) {
        const auto data = bytes_of(view);
        const auto sizes = draco_sizes(data);
        const uint64_t faces = std::max(sizes->faces, sizes->points / 3);
        if (faces > std::min(kFreeFaces + kFacesPerByte * data.size(), faces_left_)) {
            refuse(at, fmt::format("{} triangles and {} vertices cannot have been compressed to {} bytes", sizes->faces, sizes->points, data.size()));
            return nullptr;
        }
        faces_left_ -= faces;
        draco::DecoderBuffer buffer;
        buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
        try {
            auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
            if (mesh.ok()) return std::move(mesh).value();
            refuse(at, fmt::format("the compressed data are damaged (Draco: {})", mesh.status().error_msg_string()));
        } catch (const std::exception& e) {
            refuse(at, fmt::format("the compressed data are damaged (Draco: {})", e.what()));
        }
        return nullptr;
    }

    bool place_attributes(const Compressed& p, size_t view, const draco::Mesh& mesh) {
        for (const auto& [name, id] : p.extension()["attributes"].items()) {
            const auto accessor = (*p.primitive)["attributes"].find(name);
            if (accessor == (*p.primitive)["attributes"].end()) continue;
            if (count_of(*accessor) != mesh.num_points()) return wrong_count(p, name, count_of(*accessor), mesh.num_points());
            const size_t target = target_of(*accessor, {view, id.get<int64_t>()});
            if (placed_[target].done) continue;
            const auto unique_id = uint32_t(id.get<int64_t>());
            const std::string at = child(child(p.at, "attributes"), name);
            const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(unique_id);
            if (!attribute) return refuse(at, fmt::format("no attribute {} is compressed", unique_id));
            if (!place(*attribute, mesh.num_points(), target, at)) return false;
        }
        return true;
    }

    bool place(const draco::PointAttribute& attribute, uint32_t points, size_t target, const std::string& at) {
        const ElementLayout layout = layout_of(root_["accessors"][target]);
        if (layout.columns != 1 || uint32_t(attribute.num_components()) != layout.rows)
            return refuse(at, fmt::format("{} numbers a vertex are compressed, but the accessor is {}", attribute.num_components(),
                                          root_["accessors"][target]["type"].get_ref<const std::string&>()));
        const size_t first = out_.size();
        if (!copy_values(root_["accessors"][target]["componentType"].get<int>(), attribute, points, layout.rows, out_))
            return refuse(at, "the compressed values do not fit the accessor's component type");
        point_at(target, first);
        return true;
    }

    bool place_indices(const Compressed& p, size_t view, const draco::Mesh& mesh) {
        const uint64_t count = 3 * uint64_t(mesh.num_faces());
        if (count == 0) return refuse(p.at, "no triangle is compressed");
        if (p.is_strip() || !p.primitive->contains("indices")) {
            (*p.primitive)["mode"] = kTriangles;   // strips come out as triangles
            (*p.primitive)["indices"] = root_["accessors"].size();
            root_["accessors"].push_back({{"componentType", kUnsignedInt}, {"count", count}, {"type", "SCALAR"}});
        } else if (count_of((*p.primitive)["indices"]) != count) {
            return refuse(p.at, fmt::format("the accessor of the indices has {} elements, but {} triangles are compressed", count_of((*p.primitive)["indices"]), mesh.num_faces()));
        }
        const size_t target = target_of((*p.primitive)["indices"], {view, -1});
        if (placed_[target].done) return true;
        root_["accessors"][target]["componentType"] = kUnsignedInt;
        const size_t first = out_.size();
        out_.resize(first + count * 4);
        for (uint32_t f = 0; f < mesh.num_faces(); ++f)
            for (size_t c = 0; c < 3; ++c) {
                const uint32_t point = mesh.face(draco::FaceIndex(f))[c].value();
                std::memcpy(out_.data() + first + (size_t(f) * 3 + c) * 4, &point, 4);
            }
        point_at(target, first);
        return true;
    }

    /// What an accessor is filled with: a view's attribute, or its indices (-1).
    struct Source {
        size_t view = 0;
        int64_t id = -1;
        bool done = false;
    };

    /// The accessor to fill for the reference `accessor`: itself, or a copy of it if something else fills it already.
    size_t target_of(Json& accessor, const Source& source) {
        const auto [it, fresh] = placed_.try_emplace(accessor.get<size_t>(), source);
        if (fresh || (it->second.view == source.view && it->second.id == source.id)) return it->first;
        const Json copy = root_["accessors"][it->first];
        accessor = root_["accessors"].size();
        root_["accessors"].push_back(copy);
        return placed_.try_emplace(accessor.get<size_t>(), source).first->first;
    }

    /// The accessor's data are what stands in `out_` from `first` on.
    void point_at(size_t target, size_t first) {
        root_["accessors"][target]["bufferView"] = root_["bufferViews"].size();
        root_["accessors"][target]["byteOffset"] = 0;
        root_["bufferViews"].push_back({{"buffer", buffers_.size()}, {"byteOffset", first}, {"byteLength", out_.size() - first}});
        out_.resize((out_.size() + 3) / 4 * 4);
        placed_[target].done = true;
    }

    Json& root_;
    std::vector<Bytes>& buffers_;
    Reporter& report_;
    uint64_t faces_left_ = kFreeFaces;
    std::map<size_t, Source> placed_;   ///< accessor -> what fills it
    Bytes out_;                         ///< of the mesh that is being placed
};

/// The compressed primitives, by the view that their data are in.
std::map<size_t, std::vector<Compressed>> compressed_primitives(Json& root) {
    std::map<size_t, std::vector<Compressed>> out;
    const auto meshes = root.find("meshes");
    for (size_t m = 0; meshes != root.end() && m < meshes->size(); ++m) {
        Json& primitives = (*meshes)[m]["primitives"];
        for (size_t p = 0; p < primitives.size(); ++p) {
            if (!primitives[p].contains("extensions") || !primitives[p]["extensions"].contains(kName)) continue;
            const std::string at = child(child(child(child(child("/meshes", m), "primitives"), p), "extensions"), kName);
            out[primitives[p]["extensions"][kName]["bufferView"].get<size_t>()].push_back({&primitives[p], at});
        }
    }
    return out;
}

}  // namespace

void decompress_primitives(Json& root, std::vector<Bytes>& buffers, Reporter& report) {
    const auto by_view = compressed_primitives(root);
    if (by_view.empty()) return;
    Decompressor decompressor(root, buffers, report);
    for (const auto& [view, primitives] : by_view) {
        decompressor.decompress(view, primitives);
        if (report.failed()) return;
    }
}

}  // namespace alidade::gltf

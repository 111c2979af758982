// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/unshown.h"

#include "importers/gltf/meshopt.h"

#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

constexpr const char *kInstancing = "EXT_mesh_gpu_instancing", *kDracoExtension = "KHR_draco_mesh_compression", *kVisibility = "KHR_node_visibility";

class Pruner {
  public:
    explicit Pruner(Json& root)
        : root_(root), nodes_(array_in(root, "nodes").size()), meshes_(array_in(root, "meshes").size()), accessors_(array_in(root, "accessors").size()), views_(array_in(root, "bufferViews").size()) {}

    std::vector<bool> run() {
        const Json& scenes = array_in(root_, "scenes");
        std::vector<bool> unread(array_in(root_, "buffers").size());
        if (scenes.empty()) return unread;
        for (const Json& node : array_in(root_["scenes"][root_.value("scene", size_t(0))], "nodes")) show(node.get<size_t>());
        empty_what_is_not_shown();
        use_accessors();
        use_views();
        unread.flip();
        for (size_t i = 0; i < views_.size(); ++i) {
            Json& view = root_["bufferViews"][i];
            const Json* compressed = meshopt_of(view);
            if (!views_[i]) view = Json{{"buffer", (compressed ? *compressed : view)["buffer"]}, {"byteLength", 1}};   // of what it stands for, if compressed, others may have a use
            else if (compressed) unread[(*compressed)["buffer"].get<size_t>()] = unread[view["buffer"].get<size_t>()] = false;
            else unread[view["buffer"].get<size_t>()] = false;
        }
        return unread;
    }

  private:
    void show(size_t root) {
        std::vector<size_t> open{root};
        while (!open.empty()) {
            const size_t i = open.back();
            open.pop_back();
            Json& node = root_["nodes"][i];
            const Json* visibility = extension_in(node, kVisibility);
            if (nodes_[i] || (visibility && !visibility->value("visible", true))) continue;
            nodes_[i] = true;
            if (const auto mesh = node.find("mesh"); mesh != node.end()) meshes_[mesh->get<size_t>()] = true;
            for (const Json& child : array_in(node, "children")) open.push_back(child.get<size_t>());
        }
    }

    void empty_what_is_not_shown() {
        for (size_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i]) continue;
            Json& node = root_["nodes"][i];
            for (const char* held : {"mesh", "skin", "weights"}) node.erase(held);
            if (extension_in(node, kInstancing)) node["extensions"].erase(kInstancing);
        }
        for (size_t i = 0; i < meshes_.size(); ++i)
            if (!meshes_[i]) root_["meshes"][i]["primitives"] = Json::array(), root_["meshes"][i].erase("weights");
        for (Json& animation : array_in(root_, "animations"))
            for (Json& channel : array_in(animation, "channels")) {
                Json& target = channel["target"];
                if (target.value("path", std::string()) == "weights" && target.contains("node") && !nodes_[target["node"].get<size_t>()]) target.erase("node");
            }
    }

    void use(const Json& object, const char* member) {
        if (const auto found = object.find(member); found != object.end()) accessors_[found->get<size_t>()] = true;
    }
    void use_all(const Json& object) {
        for (const Json& accessor : object) accessors_[accessor.get<size_t>()] = true;
    }

    void use_accessors() {
        for (Json& mesh : array_in(root_, "meshes"))
            for (Json& primitive : mesh["primitives"]) {
                use(primitive, "indices");
                use_all(primitive["attributes"]);
                for (const Json& target : array_in(primitive, "targets")) use_all(target);
                if (const Json* draco = extension_in(primitive, kDracoExtension)) views_[(*draco)["bufferView"].get<size_t>()] = true;
            }
        for (Json& animation : array_in(root_, "animations"))
            for (const Json& sampler : array_in(animation, "samplers")) use(sampler, "input"), use(sampler, "output");
        for (const Json& skin : array_in(root_, "skins")) use(skin, "inverseBindMatrices");
        for (Json& node : array_in(root_, "nodes"))
            if (Json* instances = extension_in(node, kInstancing)) use_all(array_in(*instances, "attributes"));
    }

    void use_views() {
        for (size_t i = 0; i < accessors_.size(); ++i) {
            Json& accessor = root_["accessors"][i];
            if (!accessors_[i]) {
                for (const char* data : {"bufferView", "byteOffset", "sparse", "min", "max"}) accessor.erase(data);
                accessor["count"] = 1;
                continue;
            }
            use_view(accessor);
            if (!accessor.contains("sparse")) continue;
            use_view(accessor["sparse"]["indices"]);
            use_view(accessor["sparse"]["values"]);
        }
        for (const Json& image : array_in(root_, "images")) use_view(image);
    }
    void use_view(const Json& object) {
        if (const auto found = object.find("bufferView"); found != object.end()) views_[found->get<size_t>()] = true;
    }

    Json& root_;
    std::vector<bool> nodes_, meshes_, accessors_, views_;   ///< shown, or asked for
};

}  // namespace

std::vector<bool> leave_out_unshown(Json& root) { return Pruner(root).run(); }

}  // namespace alidade::gltf

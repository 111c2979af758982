// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/queries.h"
#include "tracer/compiled_scene.h"

#include <map>
#include <span>
#include <tuple>

namespace alidade {

/// Gives instances' slots their materials and interiors, each stored once.
class MaterialTable {
  public:
    explicit MaterialTable(CompiledScene& out);
    /// Those of a shape at the end of `path`, which has `count` slots, and that of its inside.
    void add_slots(const std::vector<NodeId>& path, uint32_t count, std::optional<InteriorId> interior, bool hollow, Instance& instance);
    /// Of the set at the end of `path` that carries it, if parts have their own; kNoId where nobody asks.
    uint32_t interior_of_whole(const std::vector<NodeId>& path);

  private:
    /// Without a material the slot takes glTF's default one (specification 3.9: white, metallic 1, roughness 1), added to the scene.
    SlotMaterial slot(std::optional<MaterialId> material, std::optional<InteriorId> interior, bool hollow);
    /// The space in which the patterns of `carried` are looked up on this path: an index into CompiledScene::pattern_spaces,
    /// or kNoId if it has no patterns, or if the space is flat, so that nothing in it is seen.
    uint32_t space(const CarriedMaterial& carried, const std::vector<NodeId>& path);
    uint32_t default_material();
    uint32_t add_interior(const Material& material, std::optional<InteriorId> interior, bool hollow);
    bool has_patterns(uint32_t material);

    CompiledScene& out_;
    std::map<std::tuple<uint32_t, uint32_t, bool>, uint32_t> interior_of_;   // (material, interior or kNoId, hollow) -> CompiledScene::interiors
    std::optional<uint32_t> default_;
    std::map<uint32_t, bool> has_patterns_;   // by material
    const bool interiors_count_;              // of opaque surfaces, too: they tell how others mirror, and a camera may stand in one that keeps fog out
};

/// May light pass through all layers of the material, or of one of its parts?
bool lets_light_through(const Scene& scene, uint32_t material);

/// The features of the kernel in words, by bit.
std::span<const char* const> feature_names();

/// The feature mask of the render kernel, each bit with the first thing that asked for it.
class FeatureReasons {
  public:
    void need(unsigned features, const std::string& who);
    unsigned mask() const { return mask_; }
    std::string text() const;

  private:
    static constexpr int kBits = 5;
    std::string who_[kBits];
    unsigned mask_ = 0;
};

/// Decodes the images that used materials read, and notes which features they need of the kernel. A material that cannot be rendered is an error.
void compile_materials(CompiledScene& out, const CompileOptions& options, FeatureReasons& reasons, Diagnostics& said);

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// What a file does not hold of the scene that was written to it.
#pragma once

#include "scene/scene.h"

namespace alidade {

/// `count` things of one kind.
struct Loss {
    std::string what;      ///< "cameras"
    size_t count = 0;
    std::string instead;   ///< what was written in their place; empty: nothing
};

/// A material of the scene, as messages name it.
struct MaterialRef {
    uint32_t index = kNoId;   ///< in Scene::materials; one beyond them: the one that surfaces have to which no node gives any
    std::string name;
};

/// What became of a material that was written. Without losses the file shows it as it is.
struct WrittenMaterial {
    MaterialRef material;
    std::vector<Loss> losses;
};

/// Counted by kind, in the order in which the kinds were first met.
class Losses {
  public:
    void add(const std::string& what, size_t count = 1, const std::string& instead = {});
    /// Told with the material's name, and noted with the material.
    void add_of_material(const MaterialRef& material, const std::string& what, size_t count = 1, const std::string& instead = {});
    /// A material is written, perhaps without any loss.
    void wrote(const MaterialRef& material);
    const std::vector<Loss>& list() const { return list_; }
    /// In the order in which they were written; empty for formats that do not tell.
    const std::vector<WrittenMaterial>& materials() const { return materials_; }

  private:
    WrittenMaterial& row_of(const MaterialRef& material);

    std::vector<Loss> list_;
    std::vector<WrittenMaterial> materials_;
};

/// What no format here holds: constructive geometry, clipping, interiors, inside materials, light groups, flags of visibility by ray, and what
/// surrounds the scene.
void add_common_losses(const Scene& scene, Losses& losses);

}  // namespace alidade

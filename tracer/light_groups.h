// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's light groups: which lights shine on which instances.
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// Collects what the paths to instances say, then fills CompiledScene::lit_by. A scene without light groups has none.
class LightGroups {
  public:
    explicit LightGroups(const Scene& scene);
    /// A number for what shines on the end of a path (Instance::light_set).
    uint32_t set_of(const std::vector<NodeId>& path);
    /// Once all lights are placed.
    void finish(CompiledScene& out) const;

  private:
    struct Set {
        std::vector<LightId> lights;   ///< of the innermost group on the path that has any
        bool global = true;            ///< those that are in no group, too: if all groups on the path want them
    };
    bool reaches(const Set& set, LightId light) const;

    const Scene& scene_;
    std::vector<bool> local_;          ///< by light: in a group
    std::vector<Set> sets_;
    bool any_ = false;
};

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's light groups: which lights shine on which instances.
#pragma once

#include "tracer/compiled_scene.h"

#include <map>

namespace alidade {

/// Collects what the paths to instances and lights say, then fills CompiledScene::lit_by. A scene without light groups has none. A group that is placed at
/// several places is a group at each of them.
class LightGroups {
  public:
    explicit LightGroups(const Scene& scene);
    /// A number for what shines on the end of a path (Instance::light_set).
    uint32_t set_of(const std::vector<NodeId>& path);
    /// The next of CompiledScene::lights, at the end of a path.
    void add_light(const std::vector<NodeId>& path, LightId light);
    /// Once all lights are placed.
    void finish(CompiledScene& out) const;

  private:
    struct Set {
        std::vector<uint32_t> groups;  ///< the innermost on the path that has lights, and perhaps the next one
        bool global = true;            ///< lights that are in no group, too: if all groups on the path want them
    };
    /// A number for the group at the end of the first `length` nodes of a path.
    uint32_t group_at(const std::vector<NodeId>& path, size_t length);

    const Scene& scene_;
    std::map<std::vector<uint32_t>, uint32_t> groups_;   ///< by the nodes down to them
    std::vector<uint32_t> group_of_light_;               ///< kNoId: in none
    std::vector<Set> sets_;
    bool any_ = false;
};

}  // namespace alidade

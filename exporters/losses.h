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

/// Counted by kind, in the order in which the kinds were first met.
class Losses {
  public:
    void add(const std::string& what, size_t count = 1, const std::string& instead = {});
    const std::vector<Loss>& list() const { return list_; }

  private:
    std::vector<Loss> list_;
};

/// What no format here holds: constructive geometry, clipping, interiors, inside materials, light groups, flags of visibility by ray, and what
/// surrounds the scene.
void add_common_losses(const Scene& scene, Losses& losses);

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Everything that a scene can require, where nobody sees it.
#pragma once

#include "scene/queries.h"
#include "tests/tracer/scene_builder.h"

#include <span>

namespace alidade::test {

/// Adds what requires `what`: as a node that the caller hides, or, of what a scene has as a whole, switched off (`as_a_whole`).
struct UnusedFeature {
    Requirement what;
    void (*add)(SceneBuilder& b, std::vector<NodeId>& nodes);
    bool as_a_whole = false;
};

/// A row for each requirement, in their order.
std::span<const UnusedFeature> unused_features();

/// `b` with the feature below a node that is hidden, or shown.
void add_feature(SceneBuilder& b, const UnusedFeature& feature, bool shown = false);

}  // namespace alidade::test

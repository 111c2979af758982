// SPDX-License-Identifier: Apache-2.0
/// Walks over graphs given by indices: in linear time and without recursion, because a chain may be a million nodes long.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <vector>

namespace alidade {

struct TopologicalOrder {
    std::vector<uint32_t> sequence;     ///< every index once, each before its successors; incomplete if there is a cycle
    std::optional<uint32_t> on_cycle;   ///< an index that leads back to itself
};

/// Orders the indices 0 .. count-1; `successors(i, f)` calls f(j) for each successor j of i (repeated ones as often as they stand there).
/// Source   A. B. Kahn, "Topological sorting of large networks", CACM 5(11), 1962.
template <class Successors> TopologicalOrder topological_order(size_t count, const Successors& successors) {
    std::vector<uint32_t> waiting_for(count, 0);
    for (uint32_t i = 0; i < count; ++i) successors(i, [&](uint32_t j) { ++waiting_for[j]; });
    TopologicalOrder order;
    for (uint32_t i = 0; i < count; ++i)
        if (waiting_for[i] == 0) order.sequence.push_back(i);
    for (size_t done = 0; done < order.sequence.size(); ++done) {
        successors(order.sequence[done], [&](uint32_t j) {
            if (--waiting_for[j] == 0) order.sequence.push_back(j);
        });
    }
    if (order.sequence.size() == count) return order;
    // What still waits has a predecessor that waits: going back as many steps as there are indices ends on a cycle.
    std::vector<uint32_t> predecessor(count, 0);
    uint32_t at = 0;
    for (uint32_t i = 0; i < count; ++i) {
        if (waiting_for[i] == 0) continue;
        successors(i, [&](uint32_t j) { predecessor[j] = i; });
        at = i;
    }
    for (size_t step = 0; step < count; ++step) at = predecessor[at];
    order.on_cycle = at;
    return order;
}

/// Calls f(NodeId) for every node that `node` refers to and whose subtree is a part of it: children, clips, bounds, what a light looks like.
template <class F> void for_each_link(const Scene& scene, const Node& node, const F& f) {
    for (const NodeId child : node.children) f(child);
    for (const NodeId clip : node.clips) f(clip);
    for (const NodeId bound : node.bounds) f(bound);
    const LightId* light = std::get_if<LightId>(&node.what);
    if (!light) return;
    const Light& l = scene.lights[light->index];
    if (l.looks_like) f(*l.looks_like);
    if (l.projected_through) f(*l.projected_through);
}

/// The pattern of a PatternSignal or a ReliefSignal, null for all others. `S`: Signal, const or not.
template <class S> auto pattern_of(S& signal) -> decltype(std::get_if<PatternSignal>(&signal.what)) {
    auto* relief = std::get_if<ReliefSignal>(&signal.what);
    return relief ? &relief->pattern : std::get_if<PatternSignal>(&signal.what);
}

/// Calls f(SignalId) for every signal that `signal` reads.
template <class F> void for_each_operand(const Scene& scene, const Signal& signal, const F& f) {
    if (const auto* product = std::get_if<ProductSignal>(&signal.what)) f(product->a), f(product->b);
    if (const auto* channel = std::get_if<ChannelSignal>(&signal.what)) f(channel->of);
    const PatternSignal* pattern = pattern_of(signal);
    if (!pattern) return;
    if (pattern->source) f(*pattern->source);
    if (pattern->function)
        for (const auto& [asked, times] : function_work(scene, *pattern->function).asked) f(asked);
    for (const MapEntry& entry : pattern->map) f(entry.signal);
}

/// Calls f(MaterialId) for every material that is a part of `material`.
template <class F> void for_each_part(const Material& material, const F& f) {
    for (const auto& layer : material.layers)
        if (const auto* map = std::get_if<PovTextureMap>(&layer))
            for (const MaterialId id : map->textures) f(id);
}

/// Calls f(SignalId) for every signal of `material` that a renderer reads: all but the occlusion, which is kept for exporters.
template <class F> void for_each_signal(const Material& material, const F& f) {
    const auto maybe = [&](const std::optional<SignalId>& id) {
        if (id) f(*id);
    };
    for (const auto& layer : material.layers) {
        if (const auto* g = std::get_if<GltfPbr>(&layer)) {
            f(g->base_color);
            for (const auto* id : {&g->metallic, &g->roughness, &g->normal, &g->emissive, &g->transmission, &g->specular, &g->specular_color,
                                   &g->clearcoat, &g->clearcoat_roughness, &g->clearcoat_normal})
                maybe(*id);
        }
        if (const auto* p = std::get_if<PovFinish>(&layer)) f(p->pigment), maybe(p->normal);
        if (const auto* p = std::get_if<PovTextureMap>(&layer)) f(p->pattern);
    }
}

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/joints.h"

#include "importers/gltf/json.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

/// What weights may be off 1 together before that is worth a warning: four bytes, each rounded on its own, can be 2/255 off.
constexpr double kSumTolerance = 0.01;

double sum_of(const Vec4f& w) { return double(w.x) + double(w.y) + double(w.z) + double(w.w); }

/// The first vertex with a negative weight, or the number of vertices.
size_t find_negative(const std::vector<Vec4f>& weights) {
    const auto found = std::find_if(weights.begin(), weights.end(), [](const Vec4f& w) { return std::min({w.x, w.y, w.z, w.w}) < 0; });
    return size_t(found - weights.begin());
}

bool check_signs(const Mesh& mesh, std::span<const uint32_t> vertices, const std::string& at, Reporter& report) {
    for (size_t i = 0; i < mesh.joint_sets.size(); ++i) {
        const std::vector<Vec4f>& weights = mesh.joint_sets[i].weights;
        const size_t vertex = find_negative(weights);
        if (vertex == weights.size()) continue;
        report.error(child(at, fmt::format("WEIGHTS_{}", i)), fmt::format("vertex {} has a negative weight", vertices.empty() ? vertex : vertices[vertex]));
        return false;
    }
    return true;
}

void drop_incomplete_sets(Mesh& mesh, const std::string& at, Reporter& report) {
    const auto incomplete = [](const JointSet& set) { return set.joints.empty() || set.weights.empty(); };
    for (size_t i = 0; i < mesh.joint_sets.size(); ++i) {
        if (incomplete(mesh.joint_sets[i])) report.warning(at, fmt::format("JOINTS_{} and WEIGHTS_{} are only used together: both are left out", i, i));
    }
    mesh.joint_sets.erase(std::remove_if(mesh.joint_sets.begin(), mesh.joint_sets.end(), incomplete), mesh.joint_sets.end());
}

void check_sums(const Mesh& mesh, std::span<const uint32_t> vertices, const std::string& at, Reporter& report) {
    size_t off = 0, first = 0, weightless = 0;
    for (size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        double sum = 0;
        for (const JointSet& set : mesh.joint_sets) sum += sum_of(set.weights[vertex]);
        if (sum == 0) ++weightless;
        else if (std::abs(sum - 1) > kSumTolerance && off++ == 0) first = vertices.empty() ? vertex : vertices[vertex];
    }
    if (off) report.warning(at, fmt::format("the joint weights of {} vertices do not add up to 1: they are scaled; the first is vertex {}", off, first));
    if (weightless) report.warning(at, fmt::format("{} vertices have no joint weights: no joint moves them", weightless));
}

}  // namespace

bool finish_joints(Mesh& mesh, std::span<const uint32_t> vertices, const std::string& at, Reporter& report) {
    if (!check_signs(mesh, vertices, at, report)) return false;
    drop_incomplete_sets(mesh, at, report);
    if (!mesh.joint_sets.empty()) check_sums(mesh, vertices, at, report);
    return true;
}

}  // namespace alidade::gltf

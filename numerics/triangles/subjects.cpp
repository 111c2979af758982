// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/subjects.h"

#include "numerics/triangles/rays.h"

#include <fmt/format.h>

namespace alidade::numerics {

std::string Subject::text() const { return fmt::format("{}, {}", entry->name, name(precision)); }

std::span<const Subject> subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> list;
        for (const AcceleratorEntry* entry : accelerators_under_test())
            for (const Precision precision : {Precision::float_, Precision::double_}) list.push_back({entry, precision, entry == find_accelerator("bvh") && precision == Precision::float_});
        return list;
    }();
    return all;
}

Built::Built(const Subject& of, const Mesh& source) : subject(of), mesh(source.read_at(of.precision)), accelerator(build(*of.entry, mesh, {of.precision})) {}

std::string Built::text(const Ray& ray) const { return fmt::format("{}, {}, {}", subject.text(), mesh.name, describe(ray)); }

std::vector<Built> built(Precision precision, const Mesh& source) {
    std::vector<Built> all;
    for (const Subject& subject : subjects())
        if (subject.precision == precision) all.emplace_back(subject, source);
    return all;
}

Compared::Compared(Precision precision, const Mesh& source) : mesh(source.read_at(precision)), structures(built(precision, source)) {
    structures.emplace_back(Subject{&accelerators().front(), precision, false}, source);
}

}  // namespace alidade::numerics

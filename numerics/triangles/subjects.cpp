// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/subjects.h"

#include "numerics/triangles/rays.h"

#include <fmt/format.h>

namespace alidade::numerics {

namespace {

std::vector<Subject> subjects_with(Intersect how, const NumericsAsked& asked) {
    std::vector<Subject> list;
    for (const AcceleratorEntry* entry : accelerators_under_test())
        for (const Precision precision : {Precision::float_, Precision::double_})
            if (asked.precision.value_or(precision) == precision) list.push_back({entry, precision, entry == find_accelerator("bvh") && precision == Precision::float_, how});
    return list;
}

struct State {
    NumericsAsked asked;
    std::vector<Subject> subjects, watertight;

    explicit State(const NumericsAsked& what) : asked(what), subjects(subjects_with(asked.intersect, asked)), watertight(subjects) {
        if (asked.intersect != Intersect::exact) return;
        const std::vector<Subject> robust = subjects_with(Intersect::robust, asked);
        watertight.insert(watertight.end(), robust.begin(), robust.end());
    }
};

State& state() {
    static State state{NumericsAsked()};
    return state;
}

}  // namespace

const NumericsAsked& asked() { return state().asked; }
void ask(const NumericsAsked& what) { state() = State(what); }
Precision precision_of(bool is_double) { return asked().precision.value_or(is_double ? Precision::double_ : Precision::float_); }

std::string Subject::text() const { return fmt::format("{}, {}{}", entry->name, name(precision), intersect == Intersect::exact ? "" : fmt::format(", {}", name(intersect))); }

std::span<const Subject> subjects() { return state().subjects; }
std::span<const Subject> watertight_subjects() { return state().watertight; }

Built::Built(const Subject& of, const TriangleMesh& source) : subject(of), mesh(source.read_at(of.precision)), accelerator(build(*of.entry, mesh, {of.precision, Isa::best, 1, of.intersect})) {}

std::string Built::text(const Ray& ray) const { return fmt::format("{}, {}, {}", subject.text(), mesh.name, describe(ray)); }

std::vector<Built> built(Precision precision, const TriangleMesh& source) {
    std::vector<Built> all;
    for (const Subject& subject : subjects())
        if (subject.precision == precision) all.emplace_back(subject, source);
    return all;
}

Compared::Compared(Precision precision, const TriangleMesh& source) : mesh(source.read_at(precision)), structures(built(precision, source)) {
    structures.emplace_back(Subject{&accelerators().front(), precision, false}, source);
}

}  // namespace alidade::numerics

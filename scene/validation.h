// SPDX-License-Identifier: Apache-2.0
/// The parts of validate().
#pragma once

#include "core/diagnostics.h"
#include "scene/scene.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace alidade {

/// How a message names a thing: its kind, its index among those of its kind, and its own name if it has one. Becomes text only where it is needed:
/// a scene may have millions of things without a fault.
struct Label {
    std::string_view kind;
    std::optional<size_t> index;
    std::string_view own_name;

    std::string text() const {
        std::string out(kind);
        if (index) out += fmt::format(" {}", *index);
        if (!own_name.empty()) out += fmt::format(" \"{}\"", own_name);
        return out;
    }
};
inline Label label(std::string_view kind, std::optional<size_t> index = std::nullopt, std::string_view own_name = {}) { return {kind, index, own_name}; }

/// The scene under examination and what was found so far.
class Validation {
  public:
    explicit Validation(const Scene& s) : scene(s) {
        for (const SourceFile& file : s.files) files_.push_back(found.add_file(file.path));
    }

    void error(const SourcePos& from, std::string message, std::string hint = {}) { found.error(moved(from), std::move(message), std::move(hint)); }
    void warning(const SourcePos& from, std::string message, std::string hint = {}) {
        found.warning(moved(from), std::move(message), std::move(hint));
    }

    /// An error unless `id` is an index of the array `things`, which holds what `kind` names.
    template <class Tag, class T> void in_range(Id<Tag> id, const std::vector<T>& things, const SourcePos& from, const Label& who, const char* kind) {
        if (id.index < things.size()) return;
        error(from, fmt::format("{} refers to {} {}, but there are only {}", who.text(), kind, id.index, things.size()));
    }

    const Scene& scene;
    Diagnostics found;

  private:
    /// Two files of a scene may have one path, and then one entry in the diagnostics. What has no place is the first file's.
    SourcePos moved(SourcePos at) const {
        const uint32_t usual = files_.empty() ? kNoFile : files_[0];
        at.file = at.file < files_.size() ? files_[at.file] : usual;
        return at;
    }

    std::vector<uint32_t> files_;
};

/// Indices from one array into another: what all other checks rely on.
void check_references(Validation& v);
void check_shapes(Validation& v);
/// Images, signals, materials and interiors.
void check_surfaces(Validation& v);
void check_media(Validation& v, const std::vector<Interior::Medium>& media, const SourcePos& from, const Label& who);
void check_lights_and_cameras(Validation& v);
void check_atmosphere(Validation& v);
/// Cycles, transforms, and what nodes say of their shapes.
void check_graph(Validation& v);
/// The steps of functions.
void check_functions(Validation& v);
/// Skins and morph targets: what deform() relies on, and how much it would make.
void check_deformations(Validation& v);
void check_animations(Validation& v);

}  // namespace alidade

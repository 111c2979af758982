// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/obj_normals.h"

#include "importers/mesh/triangulate.h"

#include <unordered_map>

namespace alidade::mesh {
namespace {

/// A direction of length 1; anything will do for a polygon without area, which no ray meets.
Vec3f unit_or_up(const Vec3& v) {
    const Vec3 n = normalized(v);
    return n == Vec3(0) || !is_finite(n) ? Vec3f(0, 0, 1) : Vec3f(n);
}

bool has_normal(const ObjText& text, const Corner& c) { return c.normal != kAbsent && text.normals[c.normal] != Vec3f(0); }

/// Calls body(section, face) for each face of the sections.
template <class Body> void for_each_face(ObjText& text, size_t first_section, size_t last_section, Body body) {
    for (size_t s = first_section; s < last_section; ++s)
        for (uint32_t f = text.sections[s].first_face; f < text.section_end(s); ++f) body(text.sections[s], text.faces[f]);
}

/// Sums of face normals around each vertex, by smoothing group.
class SmoothNormals {
  public:
    explicit SmoothNormals(ObjText& text) : text_(text) {}

    void add(const Face& face, uint32_t group) {
        const Vec3 normal = normalized(face_normal(face));
        const std::span<const Corner> corners = corners_of(std::as_const(text_), face);
        for (size_t i = 0; i < corners.size(); ++i) {
            const Vec3& here = at(corners[i]);
            const Vec3 before = at(corners[(i + corners.size() - 1) % corners.size()]) - here, after = at(corners[(i + 1) % corners.size()]) - here;
            sums_[key(corners[i], group)].sum += std::atan2(length(cross(before, after)), dot(before, after)) * normal;
        }
    }

    /// The index of the normal of a corner; added to the text when it is asked for the first time.
    uint32_t index(const Corner& corner, uint32_t group) {
        Sum& s = sums_[key(corner, group)];
        if (s.index == kAbsent) s.index = append(s.sum);
        return s.index;
    }

    uint32_t append(const Vec3& normal) {
        text_.normals.push_back(unit_or_up(normal));
        return uint32_t(text_.normals.size() - 1);
    }
    Vec3 face_normal(const Face& face) {
        polygon_.clear();
        for (const Corner& c : corners_of(std::as_const(text_), face)) polygon_.push_back(at(c));
        return area_vector(polygon_);
    }

  private:
    struct Sum {
        Vec3 sum{0};
        uint32_t index = kAbsent;
    };
    static uint64_t key(const Corner& corner, uint32_t group) { return uint64_t(group) << 32 | corner.position; }
    const Vec3& at(const Corner& corner) const { return text_.positions[corner.position]; }

    ObjText& text_;
    std::unordered_map<uint64_t, Sum> sums_;
    std::vector<Vec3> polygon_;
};

}  // namespace

void complete_normals(ObjText& text, size_t first_section, size_t last_section) {
    bool any = false, all = true;
    for_each_face(text, first_section, last_section, [&](const Section& section, const Face& face) {
        any = any || section.smoothing != 0;
        for (const Corner& c : corners_of(text, face)) {
            const bool has = has_normal(text, c);
            any = any || has, all = all && has;
        }
    });
    if (any && all) return;

    SmoothNormals smooth(text);
    for_each_face(text, first_section, last_section, [&](const Section& section, const Face& face) {
        if (any && section.smoothing) smooth.add(face, section.smoothing);
    });
    for_each_face(text, first_section, last_section, [&](const Section& section, const Face& face) {
        uint32_t flat = kAbsent;
        for (Corner& c : corners_of(text, face)) {
            if (any && has_normal(text, c)) continue;
            c.normal = kAbsent;
            if (!any) continue;
            if (section.smoothing) c.normal = smooth.index(c, section.smoothing);
            else c.normal = flat = flat == kAbsent ? smooth.append(smooth.face_normal(face)) : flat;
        }
    });
}

}  // namespace alidade::mesh

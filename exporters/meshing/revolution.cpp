// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/revolution.h"

namespace alidade::meshing {
namespace {

class Revolution {
  public:
    Revolution(const Vec3& base, const Vec3& axis, int segments, TriangleList& out) : base_(base), axis_(axis), segments_(segments), out_(out) {
        orthonormal_basis(axis, s_, t_);
    }

    /// The vertices of a circle; on the axis it is one.
    std::vector<uint32_t> ring(const Vec2& point) {
        if (point.x == 0) return std::vector<uint32_t>(size_t(segments_), out_.position(base_ + point.y * axis_));
        return around(0, [&](const Vec3& outwards) { return out_.position(base_ + point.x * outwards + point.y * axis_); });
    }

    void strip(const ProfilePiece& piece, const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
        const std::vector<uint32_t> at_a = normals(piece.a, piece.normal_a), at_b = normals(piece.b, piece.normal_b);
        for (size_t i = 0; i < size_t(segments_); ++i) {
            const size_t next = (i + 1) % size_t(segments_);
            if (a[i] == a[next]) out_.triangle({a[i], b[next], b[i]}, {at_a[i], at_b[next], at_b[i]});
            else if (b[i] == b[next]) out_.triangle({a[i], a[next], b[i]}, {at_a[i], at_a[next], at_b[i]});
            else out_.quad({a[i], a[next], b[next], b[i]}, {at_a[i], at_a[next], at_b[next], at_b[i]});
        }
    }

  private:
    /// One a corner: at the tip of a cone the normal of a triangle is that of its middle.
    std::vector<uint32_t> normals(const Vec2& point, const Vec2& normal) {
        return around(point.x == 0 ? 0.5 : 0.0, [&](const Vec3& outwards) { return out_.normal(normal.x * outwards + normal.y * axis_); });
    }

    template <class F> std::vector<uint32_t> around(double offset, const F& make) {
        std::vector<uint32_t> out;
        for (int i = 0; i < segments_; ++i) {
            const double angle = 2 * kPi * (i + offset) / segments_;
            out.push_back(make(std::cos(angle) * s_ + std::sin(angle) * t_));
        }
        return out;
    }

    Vec3 base_, axis_, s_, t_;
    int segments_;
    TriangleList& out_;
};

}  // namespace

ProfilePiece straight_piece(const Vec2& a, const Vec2& b) {
    const double size = std::hypot(b.x - a.x, b.y - a.y);
    const Vec2 normal((b.y - a.y) / size, (a.x - b.x) / size);
    return {a, b, normal, normal};
}

std::vector<ProfilePiece> arc_pieces(const Vec2& center, double radius, double from, double to, int count) {
    std::vector<ProfilePiece> out;
    const auto normal = [&](int i) {
        const double angle = from + (to - from) * i / count;
        return Vec2(std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < count; ++i) out.push_back({center + radius * normal(i), center + radius * normal(i + 1), normal(i), normal(i + 1)});
    for (size_t i = 1; i < out.size(); ++i) out[i].a = out[i - 1].b;
    return out;
}

void revolve(const std::vector<ProfilePiece>& profile, const Vec3& base, const Vec3& axis, int segments, TriangleList& out) {
    Revolution revolution(base, axis, segments, out);
    std::vector<uint32_t> first, last;
    for (size_t i = 0; i < profile.size(); ++i) {
        const std::vector<uint32_t> a = i > 0 && profile[i].a == profile[i - 1].b ? last : revolution.ring(profile[i].a);
        if (i == 0) first = a;
        last = i > 0 && i + 1 == profile.size() && profile[i].b == profile[0].a ? first : revolution.ring(profile[i].b);
        revolution.strip(profile[i], a, last);
    }
}

}  // namespace alidade::meshing

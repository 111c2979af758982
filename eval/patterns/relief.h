// SPDX-License-Identifier: Apache-2.0
/// A ReliefSignal, ready to be asked.
#pragma once

#include "eval/patterns/pattern.h"

namespace alidade {

/// Normals are unit vectors. A relief with a map of its own bends nothing itself: whoever knows its entries mixes their normals at place(), in the space that inwards() leads to.
class Relief {
  public:
    /// Or why not, as Pattern::make.
    static tl::expected<Relief, std::string> make(const ReliefSignal& signal, PatternSource source = {});

    Vec3 place(const Vec3& p) const { return pattern_.place(p); }
    const Pattern& pattern() const { return pattern_; }
    bool scaled() const { return scaled_; }

    /// A normal in the space of the pattern, all transformations of its warps undone; and back, of unit length.
    Vec3 inwards(const Vec3& n) const { return scaled_ ? normalized(pattern_.normal_in() * n) : pattern_.normal_in() * n; }
    Vec3 outwards(const Vec3& n) const { return normalized(pattern_.normal_out() * n); }
    /// The normal `n`, bent by the relief at a place, both in the space of the pattern. Not a unit vector.
    /// Source   POV-Ray 3.7 user documentation, 3.4.6.4 "Normal"; by experiment: 5 (0.02 / accuracy) times the differences of heights towards four points of a tetrahedron.
    Vec3 bent(const Vec3& place, const Vec3& n) const;

  private:
    Vec3 embossed(const Vec3& place, const Vec3& n) const;

    Pattern pattern_;
    double amount_ = 0.5, accuracy_ = 0.02;
    bool scaled_ = true;
    std::vector<SlopeEntry> slopes_;
};

/// The height of a relief where its pattern has `value`: between two entries the cubic with their heights and slopes.
double height_at(std::span<const SlopeEntry> slopes, double value);

}  // namespace alidade

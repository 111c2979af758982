// SPDX-License-Identifier: Apache-2.0
/// Decoded images, patterns made ready, and signals evaluated at a surface point.
#pragma once

#include "core/diagnostics.h"
#include "core/image.h"
#include "eval/patterns/relief.h"
#include "eval/patterns/space_pigments.h"
#include "scene/scene.h"
#include "tracer/shade_point.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace alidade {

/// Where patterns are looked up, and how normals come there and back. The evaluation of one texture has one frame: what it looks up in a map of textures, it does in that map's
/// space, and comes back; but the normals stay there, so that those of all textures that are evaluated later are bent in it (POV-Ray has it so: probed).
struct PatternFrame {
    Vec3 at{0};
    Mat3 normal_in{1.0}, normal_out{1.0};
    const ShadePoint* surface = nullptr;   ///< whose (u, v) those are looked up at that follow it
    bool mapped = false;                   ///< by a map of textures at least: normals are unit there, whatever scales

    Vec3 surface_place() const { return surface ? surface->uv_place() : Vec3(0); }
    /// That of `pattern`. One that follows the surface has the normals of the world, unless it turns with its object or is in a map.
    PatternFrame under(const PatternSignal& pattern) const {
        if (!pattern.uv_mapped) return *this;
        const Mat3 in = glm::transpose(pattern.bumps_turned), out = glm::transpose(glm::inverse(pattern.bumps_turned));
        if (pattern.bumps_turn || mapped) return {surface_place(), in * normal_in, normal_out * out, surface, mapped};
        return {surface_place(), in, out, surface};
    }
};

/// The frame of a point's own material.
PatternFrame pattern_frame(const ShadePoint& point);

/// The images that used materials read, each decoded once for each encoding that is asked of it.
class Textures {
  public:
    /// Decodes, in parallel, what the signals in `used` read. An image that cannot be decoded and a pattern that does not exist are errors in `said`.
    Textures(const Scene& scene, const std::vector<SignalId>& used, int threads, Diagnostics& said);
    Textures(const Textures&) = delete;   // patterns point back to it

    /// The value of a signal at a surface point. Channels that an image does not have: gray is repeated, alpha is 1.
    Vec4 evaluate(SignalId signal, const ShadePoint& point) const;

    /// The same, as a pigment of POV-Ray has it. What an image lets through by its alpha is transmitted.
    PigmentColor pigment(SignalId signal, const ShadePoint& point, const Vec3& at) const;
    /// A pigment that stands nowhere but in space.
    PigmentColor pigment(SignalId signal, const Vec3& at) const;

    /// The unit normal `n`, in world space, bent by a ReliefSignal; no number where the relief is none.
    Vec3 bent(SignalId relief, const PatternFrame& frame, const Vec3& n) const;

    /// Calls f(entry, share) for the entries of a PatternSignal's map that count at a point: their shares add up to 1. `frame` is theirs meanwhile, and its normals stay so.
    template <class F> void for_each_share(SignalId pattern, PatternFrame& frame, const F& f) const;

    /// Was something made ready for the signal itself: an image that it reads, its pattern or its relief?
    bool reads(SignalId signal) const { return signal.index < resource_of_.size() && resource_of_[signal.index] != kNoId; }
    size_t count() const { return pictures_.size() + space_pictures_.all().size(); }
    size_t bytes() const;

  private:
    struct Value {
        Vec4 rgba{0};
        double filter = 0, transmit = 0;
        bool ended = false;   ///< PigmentColor::ended
    };

    void add_patterns(const Scene& scene, const std::vector<SignalId>& used, Diagnostics& said);
    tl::expected<PatternSource, std::string> source_of(const PatternSignal& signal, const Scene& scene);
    /// `at` is where patterns are looked up.
    Value value(SignalId signal, const ShadePoint& point, const Vec3& at) const;
    Value mapped(const PatternSignal& signal, const Pattern& pattern, const ShadePoint& point, const Vec3& outside) const;
    /// The same in the space of the relief above.
    Vec3 bent_there(SignalId relief, const Vec3& place, const Vec3& n) const;
    Vec4 lookup(const ImageSignal& image, const Picture& picture, const Vec2& uv) const;

    const std::vector<Signal>& signals_;
    std::vector<Picture> pictures_;
    SpacePictures space_pictures_;
    std::vector<Pattern> patterns_;
    std::vector<Relief> reliefs_;
    std::vector<uint32_t> resource_of_;   ///< by signal: its picture, its pattern or its relief; kNoId where the signal is none of them
};

template <class F> void Textures::for_each_share(SignalId signal, PatternFrame& frame, const F& f) const {
    const Pattern& pattern = patterns_[resource_of_[signal.index]];
    const PatternSignal& own = std::get<PatternSignal>(signals_[signal.index].what);
    const Vec3 outside = frame.at;
    frame = frame.under(own);
    const Vec3 inside = pattern.place(frame.at);
    frame = {inside, pattern.normal_in() * frame.normal_in, frame.normal_out * pattern.normal_out(), frame.surface, true};
    alidade::for_each_share(own.map, pattern, inside, f);
    frame.at = outside;
}

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"

namespace alidade {

namespace {

/// Where a time falls between two keys: on `key`, or `fraction` of the way from it to the next.
struct KeyPosition {
    size_t key = 0;
    double fraction = 0, interval = 0;   ///< interval: seconds from `key` to the next
};

/// Before the first key that is the first key, after the last one the last.
KeyPosition locate(const std::vector<float>& times, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return {};
    const size_t key = size_t(after - times.begin()) - 1;
    if (after == times.end()) return {key, 0, 0};
    const double interval = double(*after) - double(times[key]);
    return {key, (time - double(times[key])) / interval, interval};
}

Vec4 unit(const Vec4& q) {
    const double norm = std::sqrt(dot(q, q));
    return norm > 0 ? q / norm : Vec4(0, 0, 0, 1);
}

/// Along the shorter arc between two unit quaternions.
/// Source   K. Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
Vec4 slerp(const Vec4& a, Vec4 b, double fraction) {
    double cosine = dot(a, b);
    if (cosine < 0) b = -b, cosine = -cosine;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    if (sine < 1e-8) return unit(a + fraction * (b - a));   // here the arc and its chord differ by less than rounding
    const double angle = std::atan2(sine, cosine);
    return unit(std::sin((1 - fraction) * angle) / sine * a + std::sin(fraction * angle) / sine * b);
}

/// The value of one channel at a time; `width` numbers.
class Sampler {
  public:
    Sampler(const Channel& channel, double time) : channel_(channel), at_(locate(channel.times, time)) {}

    std::vector<double> sample() const {
        if (channel_.interpolation == Interpolation::cubic) return cubic();
        if (channel_.interpolation == Interpolation::step || at_.fraction == 0) return row(at_.key);
        if (channel_.path == ChannelPath::rotation) return rotation();
        std::vector<double> out = row(at_.key);
        const std::vector<double> next = row(at_.key + 1);
        for (size_t i = 0; i < out.size(); ++i) out[i] = (1 - at_.fraction) * out[i] + at_.fraction * next[i];
        return out;
    }

  private:
    std::vector<double> row(size_t index) const {
        const auto first = channel_.values.begin() + std::ptrdiff_t(index * channel_.width);
        return {first, first + channel_.width};
    }

    std::vector<double> rotation() const {
        const std::vector<double> a = row(at_.key), b = row(at_.key + 1);
        const Vec4 q = slerp(unit({a[0], a[1], a[2], a[3]}), unit({b[0], b[1], b[2], b[3]}), at_.fraction);
        return {q.x, q.y, q.z, q.w};
    }

    /// A Hermite spline; a key is three rows: in-tangent, value, out-tangent.
    /// Source   glTF 2.0, appendix C.5 "Cubic Spline Interpolation".
    std::vector<double> cubic() const {
        std::vector<double> value = row(3 * at_.key + 1);
        if (at_.fraction == 0) return value;
        const std::vector<double> out_tangent = row(3 * at_.key + 2), in_tangent = row(3 * at_.key + 3), next = row(3 * at_.key + 4);
        const double s = at_.fraction, s2 = s * s, s3 = s2 * s;
        for (size_t i = 0; i < value.size(); ++i) {
            value[i] = (2 * s3 - 3 * s2 + 1) * value[i] + at_.interval * (s3 - 2 * s2 + s) * out_tangent[i] + (3 * s2 - 2 * s3) * next[i] +
                       at_.interval * (s3 - s2) * in_tangent[i];
        }
        return value;
    }

    const Channel& channel_;
    KeyPosition at_;
};

void apply(const Channel& channel, double time, Node& node) {
    if (channel.times.empty()) return;
    std::vector<double> v = Sampler(channel, time).sample();
    if (channel.path == ChannelPath::weights) {
        node.morph_weights = std::move(v);
        return;
    }
    if (!node.trs) return;   // a matrix cannot be taken apart: validate() says so
    switch (channel.path) {
        case ChannelPath::translation: node.trs->translation = {v[0], v[1], v[2]}; break;
        case ChannelPath::rotation: node.trs->rotation = unit({v[0], v[1], v[2], v[3]}); break;
        case ChannelPath::scale: node.trs->scale = {v[0], v[1], v[2]}; break;
        case ChannelPath::weights: break;
    }
    node.to_parent = node.trs->transform();
}

}  // namespace

Scene pose(const Scene& scene, double time) {
    Scene posed = scene;
    for (const Animation& animation : scene.animations)
        for (const Channel& channel : animation.channels) apply(channel, time, posed.nodes[channel.target.index]);
    return deform(std::move(posed));
}

}  // namespace alidade

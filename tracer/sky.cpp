// SPDX-License-Identifier: Apache-2.0
#include "tracer/sky.h"

#include "eval/texture_reads.h"
#include "tracer/sampler.h"

namespace alidade {
namespace {

Color pixel(const Picture& p, int x, int y) {
    const float* v = p.at(x, y);
    ++texture_reads;
    return p.channels >= 3 ? Color(v[0], v[1], v[2]) : Color(v[0]);
}

/// The cell of a cumulative table (first element: the sum up to and including cell 0) in which `x` of its total lies, and where in the cell.
size_t find_cell(const double* cumulative, size_t count, double x, double& fraction) {
    const double target = x * cumulative[count - 1];
    const size_t cell = std::min(size_t(std::upper_bound(cumulative, cumulative + count, target) - cumulative), count - 1);
    const double below = cell ? cumulative[cell - 1] : 0, size = cumulative[cell] - below;
    fraction = size > 0 ? std::clamp((target - below) / size, 0.0, 1.0) : 0.5;
    return cell;
}

}  // namespace

Sky::Sky(Picture image, double strength) : image_(std::move(image)), strength_(strength) {
    double total = 0;
    columns_.reserve(size_t(image_.width) * size_t(image_.height));
    for (int y = 0; y < image_.height; ++y) {
        const double solid = std::sin(kPi * (y + 0.5) / image_.height);
        double row = 0;
        for (int x = 0; x < image_.width; ++x) columns_.push_back(row += std::max(luminance(pixel(image_, x, y)), 0.0) * solid);
        rows_.push_back(total += row);
    }
    lights_ = total > 0 && std::isfinite(total);
}

Color Sky::radiance(const Vec3& d) const {
    if (seen_) return seen_(d);
    if (!image_.width) return color_;
    double column = 0.5 + std::atan2(d.z, d.x) / (2 * kPi);
    column -= std::floor(column);
    const double row = std::acos(std::clamp(d.y, -1.0, 1.0)) / kPi;
    const int x = std::min(int(column * image_.width), image_.width - 1), y = std::min(int(row * image_.height), image_.height - 1);
    return pixel(image_, x, y) * strength_;
}

Vec3 Sky::direction_of(double column, double row) const {
    const double phi = 2 * kPi * (column - 0.5), theta = kPi * row;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

Sky::Sample Sky::sample(const Vec3& n, const Vec2& square) const {
    if (!image_.width) {   // the disc lifted onto the hemisphere (Malley's method): density cos / pi
        const Vec2 disc = concentric_disc(square);
        const double z = std::sqrt(std::max(0.0, 1 - disc.x * disc.x - disc.y * disc.y));
        Vec3 s, t;
        orthonormal_basis(n, s, t);
        return {normalized(s * disc.x + t * disc.y + n * z), color_, z / kPi};
    }
    double fx = 0, fy = 0;
    const size_t width = size_t(image_.width), y = find_cell(rows_.data(), rows_.size(), square.y, fy);
    const double* row = &columns_[y * width];
    const size_t x = find_cell(row, width, square.x, fx);
    const double share = (row[x] - (x ? row[x - 1] : 0)) / rows_.back();   // of all samples, in this pixel
    const double v = (double(y) + fy) / image_.height, solid = 2 * kPi / image_.width * (kPi / image_.height) * std::sin(kPi * v);
    return {direction_of((double(x) + fx) / image_.width, v), pixel(image_, int(x), int(y)) * strength_, solid > 0 ? share / solid : 0};
}

}  // namespace alidade

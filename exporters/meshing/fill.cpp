// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/fill.h"

#include <algorithm>
#include <map>
#include <set>

namespace alidade::meshing {
namespace {

struct Edge {
    Vec2 a, b;
    size_t low, high;                  ///< heights

    double x_at(double y) const {
        if (y == a.y) return a.x;
        if (y == b.y) return b.x;
        return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    }
};

/// The height at which two edges cross between their ends.
std::optional<double> crossing_height(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 u = b - a, v = d - c, w = c - a;
    const double area = u.x * v.y - u.y * v.x;
    if (area == 0) return std::nullopt;
    const double s = (w.x * v.y - w.y * v.x) / area, t = (w.x * u.y - w.y * u.x) / area;
    if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
    return a.y + s * u.y;
}

class Filling {
  public:
    Filling(const std::vector<std::vector<Vec2>>& loops, const std::function<bool(int, int)>& inside) : loops_(loops), inside_(inside) {}

    std::optional<Filled> make() {
        find_heights();
        size_t lines = 0;
        for (const Edge& e : edges_) lines += e.high - e.low;
        if (lines > kMostSplitLines) return std::nullopt;
        find_points();
        for (size_t k = 0; k + 1 < heights_.size(); ++k) fill_slab(k);
        find_rim();
        return std::move(out_);
    }

  private:
    template <class F> void each_edge(const F& f) const {
        for (const std::vector<Vec2>& loop : loops_)
            for (size_t i = 0; i < loop.size(); ++i) f(loop[i], loop[(i + 1) % loop.size()]);
    }

    size_t rank(double y) const { return size_t(std::lower_bound(heights_.begin(), heights_.end(), y) - heights_.begin()); }

    void find_heights() {
        std::vector<std::pair<Vec2, Vec2>> all;
        each_edge([&](const Vec2& a, const Vec2& b) {
            heights_.push_back(a.y);
            all.emplace_back(a, b);
            size_ = std::max({size_, std::abs(a.x), std::abs(a.y)});
        });
        for (size_t i = 0; i < all.size(); ++i)
            for (size_t j = i + 1; j < all.size(); ++j) {
                const auto& [a, b] = all[i];
                const auto& [c, d] = all[j];
                if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) continue;
                if (const auto y = crossing_height(a, b, c, d)) heights_.push_back(*y);
            }
        std::sort(heights_.begin(), heights_.end());
        heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
        for (const auto& [a, b] : all)
            if (a.y != b.y) edges_.push_back({a, b, rank(std::min(a.y, b.y)), rank(std::max(a.y, b.y))});
    }

    /// All ends and crossings of edges with heights, sorted at each height. Those that lie together but for rounding are one.
    void find_points() {
        std::vector<std::vector<double>> xs(heights_.size());
        each_edge([&](const Vec2& a, const Vec2&) { xs[rank(a.y)].push_back(a.x); });
        for (const Edge& e : edges_)
            for (size_t k = e.low; k <= e.high; ++k) xs[k].push_back(e.x_at(heights_[k]));
        rows_.resize(heights_.size());
        for (size_t k = 0; k < xs.size(); ++k) {
            std::sort(xs[k].begin(), xs[k].end());
            for (const double x : xs[k]) {
                if (!rows_[k].empty() && x - out_.points[rows_[k].back()].x <= kTogether * size_) continue;
                rows_[k].push_back(uint32_t(out_.points.size()));
                out_.points.emplace_back(x, heights_[k]);
            }
        }
    }

    /// The place in row k of the point at x.
    size_t place(size_t k, double x) const {
        const auto& row = rows_[k];
        const auto after = std::upper_bound(row.begin(), row.end(), x + kTogether * size_ / 2, [&](double at, uint32_t p) { return at < out_.points[p].x; });
        return after == row.begin() ? 0 : size_t(after - row.begin()) - 1;
    }

    /// The sides that no two triangles share, and the lines that they are parts of.
    void find_rim() {
        std::map<std::pair<uint32_t, uint32_t>, size_t> lines;
        size_t line = 0;
        each_edge([&](const Vec2& a, const Vec2& b) {
            const std::vector<uint32_t> points = points_of(a, b);
            for (size_t i = 0; i + 1 < points.size(); ++i) lines[std::minmax(points[i], points[i + 1])] = line;
            ++line;
        });
        std::set<std::pair<uint32_t, uint32_t>> sides;
        const auto each_side = [&](const auto& f) {
            for (const Index3& t : out_.triangles)
                for (int c = 0; c < 3; ++c) f(t[c], t[(c + 1) % 3]);
        };
        each_side([&](uint32_t a, uint32_t b) { sides.emplace(a, b); });
        each_side([&](uint32_t a, uint32_t b) {
            if (sides.contains({b, a})) return;
            const auto known = lines.find(std::minmax(a, b));
            out_.rim.push_back({a, b, known == lines.end() ? std::nullopt : std::optional(known->second)});
        });
    }

    /// All points of an edge, from a to b.
    std::vector<uint32_t> points_of(const Vec2& a, const Vec2& b) const {
        std::vector<uint32_t> out;
        if (a.y == b.y) {
            const size_t k = rank(a.y), first = place(k, std::min(a.x, b.x)), last = place(k, std::max(a.x, b.x));
            out.assign(rows_[k].begin() + ptrdiff_t(first), rows_[k].begin() + ptrdiff_t(last) + 1);
            if (b.x < a.x) std::reverse(out.begin(), out.end());
        } else {
            const Edge e{a, b, rank(std::min(a.y, b.y)), rank(std::max(a.y, b.y))};
            for (size_t k = e.low; k <= e.high; ++k) out.push_back(rows_[k][place(k, e.x_at(heights_[k]))]);
            if (b.y < a.y) std::reverse(out.begin(), out.end());
        }
        return out;
    }

    void fill_slab(size_t k) {
        struct Side {
            double x;
            size_t low, high;          ///< its places in the rows below and above
            int turn;
        };
        std::vector<Side> sides;
        for (const Edge& e : edges_) {
            if (e.low > k || e.high <= k) continue;
            const double low = e.x_at(heights_[k]), high = e.x_at(heights_[k + 1]);
            sides.push_back({low + high, place(k, low), place(k + 1, high), e.b.y > e.a.y ? 1 : -1});
        }
        std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.x < b.x; });
        int winding = 0;
        for (size_t i = 0; i + 1 < sides.size(); ++i) {
            winding += sides[i].turn;
            if (inside_(winding, int(i) + 1)) strip(k, {sides[i].low, sides[i + 1].low}, {sides[i].high, sides[i + 1].high});
        }
    }

    using Range = std::pair<size_t, size_t>;
    /// Triangles between the points of two rows.
    void strip(size_t k, const Range& low, const Range& high) {
        const auto& below = rows_[k];
        const auto& above = rows_[k + 1];
        size_t i = low.first, j = high.first;
        const auto share = [](size_t at, const Range& range) { return range.second > range.first ? double(at - range.first + 1) / double(range.second - range.first) : 2.0; };
        while (i < low.second || j < high.second) {
            const bool step_below = j >= high.second || (i < low.second && share(i, low) <= share(j, high));
            if (step_below) out_.triangles.emplace_back(below[i], below[i + 1], above[j]), ++i;
            else out_.triangles.emplace_back(below[i], above[j + 1], above[j]), ++j;
        }
    }

    static constexpr double kTogether = 1e-12;

    const std::vector<std::vector<Vec2>>& loops_;
    const std::function<bool(int, int)>& inside_;
    std::vector<double> heights_;
    std::vector<Edge> edges_;
    std::vector<std::vector<uint32_t>> rows_;
    double size_ = 0;
    Filled out_;
};

}  // namespace

std::optional<Filled> fill(const std::vector<std::vector<Vec2>>& loops, const std::function<bool(int, int)>& inside) {
    size_t points = 0;
    for (const auto& loop : loops) points += loop.size();
    if (points > kMostFilledPoints) return std::nullopt;
    return Filling(loops, inside).make();
}

}  // namespace alidade::meshing

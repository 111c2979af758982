// SPDX-License-Identifier: Apache-2.0
#include "stress/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade {

namespace {

using Row = std::vector<std::string>;

/// The first row heads the columns; the first `left` of them stand to the left, the others to the right.
std::string aligned(const std::vector<Row>& rows, size_t left) {
    std::vector<size_t> widths(rows.front().size());
    for (const Row& row : rows)
        for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string out;
    for (const Row& row : rows) {
        std::string line;
        for (size_t i = 0; i < row.size(); ++i) line += fmt::format(fmt::runtime(i < left ? "  {:<{}}" : "  {:>{}}"), row[i], widths[i]);
        out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return out;
}

std::string text(const std::optional<size_t>& value) { return value ? fmt::format("{}", *value) : "-"; }
std::string text(const std::optional<double>& value, const char* format) { return value ? fmt::format(fmt::runtime(format), *value) : "-"; }

/// Half of what lies between the fastest and the slowest round, in percent of the median.
std::string spread_text(const Spread& s, int rounds) { return rounds > 1 && s.median > 0 ? fmt::format("{:.0f}", 50 * (s.high - s.low) / s.median) : "-"; }

/// "sort out 4 %, divide 80 %, pack 16 %".
std::string phases_text(const std::vector<BuildPhase>& phases) {
    double all = 0;
    for (const BuildPhase& phase : phases) all += phase.seconds;
    std::string out;
    for (const BuildPhase& phase : phases) out += fmt::format("{}{} {:.0f} %", out.empty() ? "" : ", ", phase.name, all > 0 ? 100 * phase.seconds / all : 0);
    return out.empty() ? "-" : out;
}

std::string structures(const StressFigures& figures) {
    std::vector<Row> rows{{"accelerator", "precision", "build s", "Mtri/s", "bytes/tri", "peak/tri", "nodes", "depth", "SAH cost", "phases of a build"}};
    const double triangles = double(figures.triangles);
    for (const StressPeerFigures& peer : figures.peers) {
        if (!peer.left_out.empty()) continue;
        const StressStructure& s = peer.structure;
        const auto peak = peer.peak_bytes ? std::optional(double(*peer.peak_bytes) / triangles) : std::nullopt;
        rows.push_back({peer.name, peer.precision, fmt::format("{:.4g}", peer.build_seconds.median), fmt::format("{:.2f}", 1e-6 * triangles / peer.build_seconds.median),
                        fmt::format("{:.1f}", double(s.bytes) / triangles), text(peak, "{:.1f}"), text(s.nodes), text(s.depth), text(s.sah_cost, "{:.1f}"), phases_text(s.phases)});
    }
    return rows.size() > 1 ? aligned(rows, 2) : "";
}

/// The events that were counted for anything.
std::vector<size_t> events_of(const StressFigures& figures) {
    std::vector<size_t> out;
    for (size_t e = 0; e < kEvents; ++e) {
        const auto has = [&](const StressPeerFigures& peer) { return std::any_of(peer.rays.begin(), peer.rays.end(), [&](const StressRayFigures& r) { return r.events[e].has_value(); }); };
        if (std::any_of(figures.peers.begin(), figures.peers.end(), has)) out.push_back(e);
    }
    return out;
}

std::string speeds(const StressFigures& figures) {
    std::vector<Row> rows{{"rays", "accelerator", "precision", "Mray/s", "+-%", "hit%", "boxes", "triangles", "decided", "unlike"}};
    const std::vector<size_t> events = events_of(figures);
    for (const size_t e : events) rows.front().push_back(kHardwareEvents[e].name);
    size_t sets = 0;
    for (const StressPeerFigures& peer : figures.peers) sets = std::max(sets, peer.rays.size());
    for (size_t s = 0; s < sets; ++s) {
        for (const StressPeerFigures& peer : figures.peers) {
            if (s >= peer.rays.size() || !peer.rays[s].left_out.empty()) continue;
            const StressRayFigures& r = peer.rays[s];
            rows.push_back({r.rays, peer.name, peer.precision, fmt::format("{:.3f}", 1e-6 * double(r.count) / r.seconds.median), spread_text(r.seconds, r.rounds),
                            fmt::format("{:.0f}", 100 * double(r.hits) / double(r.count)), text(r.boxes, "{:.1f}"), text(r.triangles, "{:.1f}"), text(r.decided, "{:.2f}"), fmt::format("{}", r.unlike)});
            for (const size_t e : events) rows.back().push_back(text(r.events[e], "{:.4g}"));
        }
    }
    return rows.size() > 1 ? aligned(rows, 3) : "";
}

std::string omissions(const StressFigures& figures) {
    std::string out;
    for (const StressPeerFigures& peer : figures.peers) {
        if (!peer.left_out.empty()) out += fmt::format("  left out: {} in {}: {}\n", peer.name, peer.precision, peer.left_out);
        for (const StressRayFigures& rays : peer.rays)
            if (!rays.left_out.empty()) out += fmt::format("  left out: {} in {}, {} rays: {}\n", peer.name, peer.precision, rays.rays, rays.left_out);
    }
    return out;
}

std::string verdict(const StressFigures& figures) {
    std::string out;
    for (const StressDisagreement& wrong : figures.disagreements) out += fmt::format("  WRONG: {}\n", wrong.sentence());
    if (figures.checked.empty()) return out;
    std::string asked;
    for (const StressChecked& checked : figures.checked) {
        const std::string one = fmt::format("{} {}", checked.count, checked.rays);
        if (asked.find(one) == asked.npos) asked += (asked.empty() ? "" : ", ") + one;   // in float and in double: mostly as many
    }
    return out + fmt::format("  {}; brute force was asked {} rays\n", figures.disagreements.empty() ? "all agree" : "they do not agree", asked);
}

}  // namespace

std::string stress_table(const StressFigures& figures) {
    const std::string built = structures(figures), traced = speeds(figures);
    return built + (built.empty() || traced.empty() ? "" : "\n") + traced + omissions(figures) + verdict(figures);
}

}  // namespace alidade

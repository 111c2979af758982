// SPDX-License-Identifier: Apache-2.0
#include "tools/stress/document.h"

#include "core/parallel.h"
#include "tools/report/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

namespace {

template <class T> Json maybe(const std::optional<T>& value) { return value ? Json(*value) : Json(); }

Json three(const Vec3& v) { return {v.x, v.y, v.z}; }

Json machine() {
    Json isas = Json::array();
    for (const Isa isa : available_isas()) isas.push_back(name(isa));
    return {{"processor", processor()}, {"processors", hardware_threads()}, {"instruction_sets", isas}};
}

Json to_json(const Spread& spread) { return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}}; }

Json to_json(const EventCounts& events) {
    Json out = Json::object();
    for (size_t e = 0; e < kEvents; ++e) out[kHardwareEvents[e].name] = maybe(events[e]);
    return out;
}

Json to_json(const StressRayFigures& r) {
    if (!r.left_out.empty()) return {{"rays", r.rays}, {"left_out", r.left_out}};
    return {{"rays", r.rays}, {"question", r.question == Question::any ? "any" : "closest"}, {"count", r.count}, {"hits", r.hits}, {"rounds", r.rounds},
            {"rays_per_second", double(r.count) / r.seconds.median}, {"round_seconds", to_json(r.seconds)}, {"boxes", maybe(r.boxes)}, {"triangles", maybe(r.triangles)},
            {"decided", maybe(r.decided)}, {"counted", to_json(r.events)}, {"hash", fmt::format("{:016x}", r.hash)}, {"unlike", r.unlike}};
}

Json to_json(const StressPeerFigures& p) {
    Json out = {{"accelerator", p.name}, {"precision", p.precision}};
    if (!p.left_out.empty()) return out["left_out"] = p.left_out, out;
    const StressStructure& s = p.structure;
    out.update({{"builds", p.builds}, {"build_seconds", to_json(p.build_seconds)}, {"bytes", s.bytes}, {"peak_bytes", maybe(p.peak_bytes)}, {"nodes", maybe(s.nodes)}, {"leaves", maybe(s.leaves)},
                {"references", maybe(s.references)}, {"removed", maybe(s.removed)}, {"depth", maybe(s.depth)}, {"sah_cost", maybe(s.sah_cost)}, {"phases", Json::array()}, {"rays", Json::array()}});
    for (const BuildPhase& phase : s.phases) out["phases"].push_back({{"name", phase.name}, {"seconds", phase.seconds}});
    for (const StressRayFigures& rays : p.rays) out["rays"].push_back(to_json(rays));
    return out;
}

Json hit_json(const StressHit& hit, Question question) {
    if (question == Question::any) return {{"hits", hit.hits()}};
    if (!hit.hits()) return {{"hits", false}};
    return {{"hits", true}, {"t", hit.t}, {"place", hit.instance}, {"triangle", hit.primitive}, {"u", hit.u}, {"v", hit.v}};
}

/// JSON has no infinities: null.

Json to_json(const StressDisagreement& d) {
    return {{"accelerator", d.peer}, {"precision", d.precision}, {"rays", d.rays}, {"ray", d.ray}, {"wrong", d.wrong}, {"origin", three(d.asked.origin)}, {"direction", three(d.asked.dir)},
            {"tmin", number_or_null(d.asked.tmin)}, {"tmax", number_or_null(d.asked.tmax)}, {"got", hit_json(d.got, d.question)}, {"right", hit_json(d.wanted, d.question)}, {"sentence", d.sentence()}};
}

Json to_json(const StressSize& size) {
    if (!size.left_out.empty()) return {{"asked", size.asked}, {"left_out", size.left_out}};
    const StressFigures& f = size.figures;
    Json out = {{"asked", size.asked}, {"triangles", f.triangles}, {"places", f.places}, {"placed_triangles", f.placed_triangles}, {"scene_bytes", f.scene_bytes}, {"make_seconds", size.make_seconds},
                {"structures", Json::array()}, {"brute_force", Json::array()}, {"disagreements", Json::array()}};
    for (const StressPeerFigures& peer : f.peers) out["structures"].push_back(to_json(peer));
    for (const StressChecked& checked : f.checked) out["brute_force"].push_back({{"rays", checked.rays}, {"precision", checked.precision}, {"count", checked.count}});
    for (const StressDisagreement& wrong : f.disagreements) out["disagreements"].push_back(to_json(wrong));
    return out;
}

Json to_json(const StressSeries& series) {
    Json out = {{"name", series.source.name}, {"kind", series.source.kind ? Json(series.source.kind->name) : Json()}, {"seed", series.source.seed}, {"sizes", Json::array()}, {"growth", Json::array()}};
    for (const StressSize& size : series.sizes) out["sizes"].push_back(to_json(size));
    for (const StressGrowth& g : series.growth)
        out["growth"].push_back({{"accelerator", g.peer}, {"precision", g.precision}, {"cost", g.cost}, {"exponent", g.law.exponent}, {"error", maybe(g.law.error)}, {"factor", g.law.factor}, {"points", g.law.points}});
    return out;
}

template <class T> std::string cell(const std::optional<T>& value) { return value ? fmt::format("{}", *value) : ""; }

constexpr const char* kCsvHead =
    "scene,seed,asked,triangles,placed_triangles,accelerator,precision,build_seconds,phases,bytes,peak_bytes,nodes,depth,sah_cost,rays,question,count,hits,rounds,rays_per_second,round_seconds_low,"
    "round_seconds_high,boxes,triangles_a_ray,decided,instructions,cycles,cache_misses,branch_misses,hash,unlike,left_out\n";
constexpr int kCsvColumns = 32;

std::string csv_line(const std::vector<std::string>& cells) { return fmt::format("{}{}\n", fmt::join(cells, ","), std::string(size_t(kCsvColumns) - cells.size(), ',')); }

/// What has no figures: all columns but the last are empty.
std::string csv_left_out(std::vector<std::string> cells, const std::string& why) {
    cells.resize(kCsvColumns - 1);
    cells.push_back(csv_cell(why));
    return csv_line(cells);
}

std::vector<std::string> csv_rays(std::vector<std::string> cells, const StressRayFigures& r) {
    for (std::string& each : std::vector<std::string>{csv_cell(r.rays), r.question == Question::any ? "any" : "closest", fmt::format("{}", r.count), fmt::format("{}", r.hits), fmt::format("{}", r.rounds),
             fmt::format("{}", double(r.count) / r.seconds.median), fmt::format("{}", r.seconds.low), fmt::format("{}", r.seconds.high), cell(r.boxes), cell(r.triangles), cell(r.decided),
             cell(r.events[0]), cell(r.events[1]), cell(r.events[2]), cell(r.events[3]), fmt::format("{:016x}", r.hash), fmt::format("{}", r.unlike)})
        cells.push_back(std::move(each));
    return cells;
}

std::string csv_peer(std::vector<std::string> cells, const StressPeerFigures& p) {
    cells.insert(cells.end(), {csv_cell(p.name), p.precision});
    if (!p.left_out.empty()) return csv_left_out(cells, p.left_out);
    const StressStructure& s = p.structure;
    std::string phases;
    for (const BuildPhase& phase : s.phases) phases += fmt::format("{}{} {}", phases.empty() ? "" : "; ", phase.name, phase.seconds);
    cells.insert(cells.end(), {fmt::format("{}", p.build_seconds.median), phases, fmt::format("{}", s.bytes), cell(p.peak_bytes), cell(s.nodes), cell(s.depth), cell(s.sah_cost)});
    std::string out;
    for (const StressRayFigures& rays : p.rays) {
        auto head = cells;
        if (rays.left_out.empty()) out += csv_line(csv_rays(cells, rays));
        else head.push_back(csv_cell(rays.rays)), out += csv_left_out(head, rays.left_out);
    }
    return out;
}

}  // namespace

Json stress_document(const StressRequest& request, const StressResults& results, int exit_code) {
    Words line = {"alidade", "stress"};
    line.insert(line.end(), request.words.begin(), request.words.end());
    Json out = {{"schema", kStressSchema}, {"alidade", ALIDADE_VERSION}, {"command", shell_line(line)}, {"machine", machine()}, {"exit_code", exit_code}, {"interrupted", results.interrupted},
                {"rounds", request.rounds}, {"threads", request.threads}, {"side", request.side}, {"seconds_budget", maybe(request.seconds)}, {"bytes_budget", number_or_null(results.bytes)}, {"scenes", Json::array()},
                {"messages", to_json(results.said)}};
    for (const StressSeries& series : results.series) out["scenes"].push_back(to_json(series));
    return out;
}

std::string stress_csv(const StressResults& results) {
    std::string out = kCsvHead;
    for (const StressSeries& series : results.series) {
        for (const StressSize& size : series.sizes) {
            std::vector<std::string> cells{csv_cell(series.source.name), fmt::format("{}", series.source.seed), fmt::format("{}", size.asked)};
            if (!size.left_out.empty()) {
                out += csv_left_out(cells, size.left_out);
                continue;
            }
            cells.insert(cells.end(), {fmt::format("{}", size.figures.triangles), fmt::format("{}", size.figures.placed_triangles)});
            for (const StressPeerFigures& peer : size.figures.peers) out += csv_peer(cells, peer);
        }
    }
    return out;
}

std::string growth_table(const std::vector<StressGrowth>& growth) {
    Json rows = Json::array();
    for (const StressGrowth& g : growth)
        rows.push_back({{"accelerator", g.peer}, {"precision", g.precision}, {"cost", g.cost}, {"exponent", fmt::format("{:.3f}", g.law.exponent)},
                        {"+-", g.law.error ? fmt::format("{:.3f}", *g.law.error) : "-"}, {"sizes", g.law.points}});
    return rows.empty() ? "" : as_text({{"growth: cost ~ triangles ^ exponent", rows}});
}

}  // namespace alidade

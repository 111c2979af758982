// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/experiment.h"

#include "core/fingerprint.h"
#include "tools/analytic.h"
#include "tools/compare/program.h"
#include "tools/identity.h"
#include "tools/load.h"
#include "tools/tradeoff/thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace alidade::tradeoff {
namespace {

/// Sums over pictures of several seeds, value by value.
class Spread {
  public:
    void add(const Picture& picture) {
        sum_.resize(picture.values.size()), squares_.resize(picture.values.size());
        for (size_t i = 0; i < picture.values.size(); ++i) {
            const double value = double(picture.values[i]);
            sum_[i] += value, squares_[i] += value * value;
        }
        ++count_;
    }
    /// The mean's squared error is bias^2 + variance / count.
    Noise against(const Picture& reference) const {
        Noise out;
        double off = 0;
        for (size_t i = 0; i < sum_.size(); ++i) {
            const double mean = sum_[i] / count_, error = mean - double(reference.values[i]);
            out.variance += std::max(squares_[i] - count_ * mean * mean, 0.0) / (count_ - 1);
            off += error * error;
        }
        const auto values = double(std::max<size_t>(sum_.size(), 1));
        out.variance /= values;
        out.bias2 = off / values - out.variance / count_;
        return out;
    }

  private:
    std::vector<double> sum_, squares_;
    double count_ = 0;
};

std::map<std::string, double> counts_of(const RenderStats& s) {
    const auto number = [](uint64_t n) { return double(n); };
    return {{"rays", number(s.camera_rays + s.shadow_rays + s.secondary_rays)}, {"camera_rays", number(s.camera_rays)}, {"shadow_rays", number(s.shadow_rays)},
            {"secondary_rays", number(s.secondary_rays)}, {"boxes", number(s.work.boxes)}, {"filtered", number(s.work.filtered)},
            {"primitives", number(s.work.primitives)}, {"exact", number(s.work.exact)}, {"texture_reads", number(s.texture_reads)}};
}

Json as_json(const Row& row) {
    Json errors = Json::object();   // an infinite one, PSNR of what is equal, is null
    for (const auto& [name, value] : row.errors) errors[name] = std::isfinite(value) ? Json(value) : Json();
    Json out = {{"errors", errors}, {"counts", row.counts}, {"non_finite", row.non_finite}, {"fingerprint", row.fingerprint}, {"thumbnail", row.thumbnail}, {"flip", row.flip}};
    if (row.noise) out["noise"] = {{"bias2", row.noise->bias2}, {"variance", row.noise->variance}};
    return out;
}

/// All of it or, with an exception, nothing.
void take_json(const Json& known, Row& row) {
    Row taken = row;
    for (const auto& [name, value] : known.at("errors").items()) taken.errors[name] = value.is_null() ? kInf : value.get<double>();
    taken.counts = known.at("counts").get<std::map<std::string, double>>();
    taken.non_finite = known.at("non_finite").get<size_t>(), taken.fingerprint = known.at("fingerprint").get<uint64_t>();
    taken.thumbnail = known.at("thumbnail").get<std::string>(), taken.flip = known.at("flip").get<std::string>();
    if (known.contains("noise")) taken.noise = Noise{known.at("noise").at("bias2").get<double>(), known.at("noise").at("variance").get<double>()};
    row = std::move(taken);
}

/// Stands for what a file holds: "" for no file. One that cannot be read is told of by who needs it.
std::string contents_of(const std::string& path) {
    if (path.empty()) return "";
    const auto bytes = read_file(path);
    return bytes ? fmt::format("{:016x}", fingerprint(*bytes)) : bytes.error();
}

/// Takes the measurements, shows how far they are, and keeps each one.
class Measuring {
  public:
    Measuring(Experiment& experiment, Renderer& renderer, Store& store)
        : e_(experiment), job_(experiment.job), renderer_(renderer), store_(store), progress_(job_.progress, stderr), spent_(experiment.rows.size(), -1) {}

    Value<bool> pictures() {
        for (size_t i = 0; i < e_.rows.size(); ++i) {
            const std::string key = "picture " + key_of(e_.rows[i]);
            if (store_.read(key, [&](const Json& known) { take_json(known, e_.rows[i]); })) continue;
            const double start = seconds_now();
            if (auto done = picture_of(e_.rows[i]); !done) return done;
            if (auto kept = store_.keep(key, as_json(e_.rows[i])); !kept) return kept;
            spent_[i] = seconds_now() - start;
            show(0, i + 1);
        }
        return true;
    }

    Value<bool> rounds() {
        for (int round = 0; round < job_.repeat; ++round) {
            const std::vector<size_t> order = shuffled(e_.rows.size(), RandomKey(0, 0, uint64_t(round)));
            for (size_t i = 0; i < order.size(); ++i) {
                if (auto done = time_of(e_.rows[order[i]], round, order[i]); !done) return done;
                show(size_t(round) * order.size() + i + 1, order.size());
            }
        }
        return true;
    }

  private:
    std::string key_of(const Row& row) const {
        std::string text = row.external < 0 ? "ours" : job_.externals[size_t(row.external)].text;
        for (const std::string& word : as_words(row.external < 0 ? row.options : row.setting)) text += " " + word;
        const std::string& environment = row.request.compile.environment_file;
        return environment.empty() ? text : text + " " + contents_of(environment);
    }

    ExternalJob external_job() const { return {job_.scene, e_.reference.picture.width, e_.reference.picture.height, job_.timeout}; }

    void measure(const Picture& picture, Row& row, int seed, double weight) {
        const MeasuredErrors measured = measure_errors(e_.reference.picture, picture, e_.clip);
        for (const auto& [name, value] : measured.values) row.errors[name] += weight * (name == "rmse" ? value * value : value);
        row.non_finite = std::max(row.non_finite, measured.non_finite);
        if (seed > 0) return;
        row.fingerprint = fingerprint(std::as_bytes(std::span(picture.values)));
        row.thumbnail = thumbnail(picture), row.flip = error_thumbnail(picture.width, picture.height, measured.flip);
    }

    Value<bool> external_picture(Row& row) {
        const auto run = run_external(job_.externals[size_t(row.external)], row.setting, external_job());
        if (!run) return tl::unexpected(run.error());
        if (run->picture.width != e_.reference.picture.width || run->picture.height != e_.reference.picture.height)
            return tl::unexpected(fmt::format("{} made {} x {} pixels, not {} x {}", row.command, run->picture.width, run->picture.height, e_.reference.picture.width, e_.reference.picture.height));
        measure(run->picture, row, 0, 1);   // it has no seeds
        return true;
    }

    Value<bool> picture_of(Row& row) {
        if (row.external >= 0) {
            if (auto done = external_picture(row); !done) return done;
        }
        Spread spread;
        for (int seed = 0; row.external < 0 && seed < job_.seeds; ++seed) {
            Request request = row.request;
            request.render.seed += uint64_t(seed);
            const auto run = renderer_.run(request, reading_of(row.options));
            if (!run) return tl::unexpected(run.error());
            if (seed == 0) row.counts = counts_of(run->stats);
            measure(run->picture, row, seed, 1.0 / job_.seeds);
            spread.add(run->picture);
        }
        if (job_.seeds > 1 && row.external < 0 && row.non_finite + count_non_finite(e_.reference.picture) == 0) row.noise = spread.against(e_.reference.picture);
        if (row.errors.contains("rmse")) row.errors["rmse"] = std::sqrt(row.errors["rmse"]);
        return true;
    }

    /// CPU seconds of a run, and of building in it. What takes milliseconds is run again until a round is long enough for one interruption to weigh little.
    Value<std::pair<double, double>> mean_time_of(const Row& row, size_t number) {
        constexpr double kShortestRound = 0.05;
        double cpu = 0, build = 0;
        int runs = 0;
        for (; cpu < kShortestRound && runs < 32; ++runs) {
            const auto run = renderer_.run(row.request, reading_of(row.options));
            if (!run) return tl::unexpected(run.error());
            cpu += run->cpu_seconds(), build += run->build_seconds;
            if (fingerprint(std::as_bytes(std::span(run->picture.values))) != row.fingerprint) e_.unrepeatable.insert(number);
        }
        return std::pair(cpu / runs, build / runs);
    }

    Value<bool> time_of(Row& row, int round, size_t number) {
        const std::string key = fmt::format("round {} {}", round, key_of(row));
        double cpu = 0, build = 0;
        if (store_.read(key, [&](const Json& known) { cpu = known.at("cpu").get<double>(), build = known.at("build").get<double>(); })) return row.seconds.push_back(cpu), row.build_seconds.push_back(build), true;
        const double start = seconds_now();
        cpu = build = 0;
        if (row.external >= 0) {
            const auto run = run_external(job_.externals[size_t(row.external)], row.setting, external_job());
            if (!run) return tl::unexpected(run.error());
            cpu = run->cpu_seconds;
        } else {
            const auto mean = mean_time_of(row, number);
            if (!mean) return tl::unexpected(mean.error());
            std::tie(cpu, build) = *mean;
        }
        row.seconds.push_back(cpu), row.build_seconds.push_back(build);
        spent_[number] = seconds_now() - start;
        return store_.keep(key, {{"cpu", cpu}, {"build", build}});
    }

    /// What is left is estimated from what each setting took, or, where that is not known, from what the others took.
    void show(size_t timed, size_t pictures) {
        double known = 0, count = 0;
        for (const double spent : spent_)
            if (spent >= 0) known += spent, ++count;
        if (count == 0) return;
        const double mean = known / count, all = double(job_.repeat + 1) * (known + mean * (double(spent_.size()) - count));
        const double gone = seconds_now() - start_, share = double(timed + pictures) / double(spent_.size() * size_t(job_.repeat + 1));
        const double left = all * (1 - share);
        progress_.update(size_t(1e6 * gone / (gone + left)), 1000000);
    }

    Experiment& e_;
    const Job& job_;
    Renderer& renderer_;
    Store& store_;
    Progress progress_;
    std::vector<double> spent_;   ///< wall seconds of the last run of each row; below 0: none
    const double start_ = seconds_now();
};

/// Whoever reads the measurements of another run has to read the same ones. A reference of our own that nobody described is whatever the folder has.
Value<Json> head_of(const Job& job, const std::vector<Row>& rows, Renderer& renderer, bool clip) {
    const auto compiled = renderer.compiled(rows[0].request, reading_of(rows[0].options));
    if (!compiled) return tl::unexpected(compiled.error());
    Json base = Json::array();
    for (const std::string& word : as_words(job.base)) base.push_back(word);
    const std::string reference = is_usual_reference(job) ? "of our own" : *reference_name(job, rows) + (is_reference_file(job) ? " " + contents_of(job.reference) : "");
    Json out = {{"schema", 1}, {"options", base}, {"reference", reference}, {"reference with", as_words(job.reference_with)}, {"environment", contents_of(rows[0].request.compile.environment_file)},
                {"seeds", job.seeds}, {"cut off", clip}};
    for (const auto& [name, value] : identity(**compiled, rows[0].request.render))
        if (name == "program" || name == "scene" || name == "size") out[name] = value;
    return out;
}

/// Callgrind's count of a whole process that renders: reading, building and writing are part of it.
Value<bool> count_instructions(const Job& job, Row& row, Store& store) {
    const std::string key = "instructions " + row.command;
    if (store.read(key, [&](const Json& known) { row.instructions = known.get<double>(); })) return true;
    const ScratchFolder scratch;
    Words words{"valgrind", "--tool=callgrind", "--callgrind-out-file=" + scratch.path() + "/counts", own_program(), "render", is_analytic(job.scene) ? job.scene : std::filesystem::absolute(job.scene).string(), "-o", scratch.path() + "/out.pfm"};
    for (const std::string& word : as_words(row.options)) words.push_back(word);
    const auto run = run_program(words, std::filesystem::current_path().string(), 60 * job.timeout);
    if (!run) return tl::unexpected(run.error());
    const size_t at = run->output.rfind("Collected : ");
    if (run->exit_code != 0 || at == std::string::npos) return tl::unexpected(fmt::format("valgrind counted nothing of {}: {}", row.command, complaint(run->output)));
    row.instructions = std::strtod(run->output.c_str() + at + 12, nullptr);
    return store.keep(key, *row.instructions);
}

void warn(Experiment& e) {
    for (const Row& row : e.rows)
        if (row.non_finite > 0) e.warnings.push_back(fmt::format("{}: {} pixels are not finite; the others are measured, and it is in no front", row.name(e.job), row.non_finite));
    if (const size_t odd = count_non_finite(e.reference.picture)) e.warnings.push_back(fmt::format("{} pixels of the reference are not finite; they are left out", odd));
    if (e.job.repeat < 3) e.warnings.push_back("fewer than 3 rounds do not say how far apart times of one setting lie: every difference is taken for one (--repeat)");
    if (e.clip) e.warnings.push_back("values are cut off at 0 and 1, which is all that a picture of display values holds");
}

}  // namespace

Value<Experiment> run_experiment(const Job& job, std::vector<Row> rows) {
    Experiment e;
    e.job = job, e.rows = std::move(rows);
    Renderer renderer;
    e.clip = !job.externals.empty();
    Store store;
    if (!job.out.empty()) {
        const auto head = head_of(job, e.rows, renderer, e.clip);
        if (!head) return tl::unexpected(head.error());
        auto opened = Store::open(job.out, *head);
        if (!opened) return tl::unexpected(opened.error());
        store = std::move(*opened);
    }
    auto reference = make_reference(job, e.rows, renderer, store, e.clip);
    if (!reference) return tl::unexpected(reference.error());
    e.reference = std::move(*reference);
    if (e.reference.what != *reference_name(job, e.rows)) e.warnings.push_back(fmt::format("{} has a reference already: {} (--reference names another)", job.out, e.reference.what));
    e.clip = e.clip || e.reference.display;
    Measuring measuring(e, renderer, store);
    if (const auto done = measuring.pictures(); !done) return tl::unexpected(done.error());
    if (const auto done = measuring.rounds(); !done) return tl::unexpected(done.error());
    for (Row& row : e.rows)
        if (job.instructions && row.external < 0)
            if (const auto done = count_instructions(job, row, store); !done) return tl::unexpected(done.error());
    warn(e);
    return e;
}

}  // namespace alidade::tradeoff

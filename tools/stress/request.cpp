// SPDX-License-Identifier: Apache-2.0
#include "tools/stress/request.h"

#include "tools/option_words.h"
#include "tools/output.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>

namespace alidade {

namespace {

constexpr size_t kGrowthLow = 1000, kGrowthHigh = 10000000;

Value<size_t> parse_count(const std::string& word) {
    const auto number = parse_number(word, -kInf);
    if (!number) return tl::unexpected(number.error());
    if (*number < 1 || *number > double(kMostStressTriangles) || *number != std::floor(*number))
        return tl::unexpected(fmt::format("'{}' is not a whole number of triangles from 1 to {}", word, kMostStressTriangles));
    return size_t(*number);
}

Value<std::vector<size_t>> parse_sizes(const std::string& word) {
    const size_t dots = word.find("..");
    if (dots == word.npos) return parse_count(word).map([](size_t count) { return std::vector<size_t>{count}; });
    const auto low = parse_count(word.substr(0, dots)), high = parse_count(word.substr(dots + 2));
    if (!low || !high) return tl::unexpected(low ? high.error() : low.error());
    if (*low >= *high) return tl::unexpected(fmt::format("'{}' does not go from a smaller number to a larger one", word));
    return sizes_between(*low, *high);
}

/// Bytes: a number, with k, M, G or T behind it for powers of 1000.
Value<double> parse_bytes(const std::string& word) {
    static constexpr std::string_view kUnits = "kMGT";
    const size_t unit = word.empty() ? kUnits.npos : kUnits.find(word.back());
    const auto number = parse_number(unit == kUnits.npos ? word : word.substr(0, word.size() - 1), 0);
    if (!number) return tl::unexpected(fmt::format("'{}' is not a number of bytes, such as 2e9 or 500M", word));
    return *number * (unit == kUnits.npos ? 1 : std::pow(1000.0, double(unit + 1)));
}

void add_what(CLI::App& app, StressRequest& request, std::vector<std::string>& generate) {
    app.add_option("--generate", generate,
                   fmt::format("a scene that is made: KIND is one of {}; N triangles (default: as the kind has it), or a range such as 1e3..1e6; may be given more than once", fmt::join(names_of(stress_kinds()), ", ")))
        ->type_name("KIND[:N][:SEED]")->allow_extra_args(false);
    app.add_flag("--growth", request.growth, fmt::format("--generate without N takes {:g}..{:g}: how costs grow", double(kGrowthLow), double(kGrowthHigh)));
    std::vector<std::string> structures = names_of(accelerators());
    structures.emplace_back("auto");
    add(app, "--accel", "A,B", [structures](const std::string& word) { return list_of(word, structures); }, [&request, structures](const std::vector<size_t>& chosen) {
        request.accelerators.clear();
        for (const size_t i : chosen) request.accelerators.push_back(find_accelerator(structures[i]));
    }, fmt::format("accelerators, of {} (default: all but auto, and but brute, which is asked about some rays in any case)", fmt::join(structures, ", ")));
    add(app, "--precision", "A,B", [](const std::string& word) { return list_of(word, {"float", "double"}); }, [&request](const std::vector<size_t>& chosen) {
        request.precisions.clear();
        for (const size_t i : chosen) request.precisions.push_back(Precision(i));
    }, "of mesh vertices and nodes: float, double (default: both)");
    add(app, "--intersect", "A,B", [](const std::string& word) { return list_of(word, names_of(intersects())); }, [&request](const std::vector<size_t>& chosen) {
        request.tests.clear();
        for (const size_t i : chosen) request.tests.push_back(intersects()[i].value);
    }, fmt::format("tests of triangles: {} (default: exact); bvh:fast is a BVH with `fast`", fmt::join(names_of(intersects()), ", ")));
    add_choice(app, "--against", {"embree"}, [&request](size_t) { request.embree = true; }, "another ray tracer beside ours, if this was built with it");
}

void add_how(CLI::App& app, StressRequest& request) {
    add_integer(app, "--side", request.side, 1, 8192, "primary rays are N x N (default 128)");
    add_integer(app, "--rounds", request.rounds, 1, 1000, "of rays, in turns; builds get half as many (default 5)");
    add_integer(app, "--threads", request.threads, 0, 4096,
                "of our builds, which are timed on the clock then; 0: as many as the machine has (default 1: CPU time); no structure depends on it");
    add_number(app, "--time", "SECONDS", 0, [&request](double s) { request.seconds = s; },
        "a budget: what is predicted not to fit is left out, and that is said (default: none)");
    add(app, "--memory", "BYTES", parse_bytes, [&request](double bytes) { request.bytes = bytes; },
        "the same for the scene and the structures over it, such as 2e9 or 500M (default: 8/10 of what is available)");
    add_choice(app, "--progress", {"bar", "json", "none"}, [&request](size_t i) { request.progress = ProgressMode(i); }, "a bar (only on a terminal), a line of JSON every 10 %, or nothing (default bar)");
}

void add_files(CLI::App& app, StressRequest& request) {
    app.add_option("--rays", request.rays, "asks these rays instead of the four kinds (docs/stress.md has the format)")->type_name("FILE");
    app.add_option("--dump-rays", request.dump_rays, "writes the rays that are asked, a file for each kind: rays.bin becomes rays.primary.bin, ...")->type_name("FILE");
    add_choice(app, "--dump-as", {"float32", "float64"}, [&request](size_t i) { request.dump_numbers = i ? RayNumbers::float64 : RayNumbers::float32; }, "numbers of --dump-rays (default float32)");
    app.add_option("--tree", request.trees, "writes the nodes of each tree as JSON, a file for each structure and precision: tree.json becomes tree.bvh.float.json, ... (docs/stress.md has the schema)")->type_name("FILE");
    app.add_option("--csv", request.csv, "writes the figures as a table for programs")->type_name("FILE");
    app.add_option_function<std::string>("--json", [&request](const std::string& file) { request.json = file, request.prints_json = file.empty(); },
        "prints JSON instead of tables, or writes it to a file (docs/stress.md)")->type_name("[FILE]")->expected(0, 1);
    app.add_option("--report", request.report, "writes one HTML file with tables and plots")->type_name("FILE");
}

/// Why the files that are asked for cannot all be written, or "".
std::string why_no_files(const StressRequest& request) {
    std::vector<std::string> taken{request.scene.scene, request.rays};
    for (const std::string& path : {request.csv, request.json, request.report, request.dump_rays, request.trees}) {
        if (path.empty()) continue;
        if (std::string why = why_no_file(path); !why.empty()) return why;
        for (const std::string& other : taken) {
            std::error_code ignored;
            if (!other.empty() && (path == other || std::filesystem::equivalent(path, other, ignored))) return fmt::format("'{}' would be overwritten: give another name", path);
        }
        taken.push_back(path);
    }
    return {};
}

/// Why the words do not go together, or "".
std::string why_not(const StressRequest& request, const std::vector<std::string>& generate) {
    if (!request.scene.scene.empty() && !generate.empty()) return "a file and --generate: give one of them";
    if (request.scene.scene.empty() && generate.empty()) return "a file or --generate KIND:N is missing, such as --generate scan:1e5";
    if (!request.scene.scene.empty() && request.growth) return "--growth needs --generate: a file has one size";
    if (request.accelerators.empty() || request.precisions.empty() || request.tests.empty()) return "there is nothing to measure";
    size_t scenes = 0;
    for (const StressSource& source : request.sources) scenes += source.sizes.size();
    if (scenes > 1 && (!request.rays.empty() || !request.dump_rays.empty() || !request.trees.empty())) return "--rays, --dump-rays and --tree are for one scene of one size";
    return {};
}

}  // namespace

std::vector<size_t> sizes_between(size_t low, size_t high) {
    const double decades = std::log10(double(high) / double(low));
    const auto steps = std::max(1, int(std::lround(2 * decades)));
    std::vector<size_t> sizes;
    for (int i = 0; i <= steps; ++i) {
        const auto size = i == steps ? high : size_t(std::lround(double(low) * std::pow(10, decades * i / steps)));
        if (sizes.empty() || size > sizes.back()) sizes.push_back(size);
    }
    return sizes;
}

Value<StressSource> parse_source(const std::string& word, bool growth) {
    const std::vector<std::string> parts = split(word, ':');
    StressSource source;
    const auto kind = one_of(parts.front(), names_of(stress_kinds()));
    if (!kind) return tl::unexpected(kind.error());
    source.name = parts.front(), source.kind = &stress_kinds()[*kind];
    if (parts.size() > 3) return tl::unexpected(fmt::format("'{}' is not KIND:N:SEED", word));
    source.sizes = growth ? sizes_between(kGrowthLow, kGrowthHigh) : std::vector<size_t>{source.kind->triangles};
    if (parts.size() > 1) {
        auto sizes = parse_sizes(parts[1]);
        if (!sizes) return tl::unexpected(sizes.error());
        source.sizes = std::move(*sizes);
    }
    if (parts.size() > 2) {
        const auto seed = parse_integer(parts[2], 0, INT64_MAX);
        if (!seed) return tl::unexpected(fmt::format("seed: {}", seed.error()));
        source.seed = uint64_t(*seed);
    }
    return source;
}

tl::expected<StressRequest, int> parse_stress_words(const Verb& verb, const Words& given) {
    StressRequest request;
    request.words = given, request.precisions = {Precision::float_, Precision::double_};
    for (const AcceleratorEntry& entry : accelerators().subspan(1)) request.accelerators.push_back(&entry);
    std::vector<std::string> generate;
    CLI::App app;
    add_scene_options(app, request.scene);
    app.remove_option(app.get_option("--time"));   // here the user's time
    app.get_option("SCENE")->required(false);
    add_what(app, request, generate);
    add_how(app, request);
    add_files(app, request);
    if (const auto code = parse_words(app, verb, given)) return tl::unexpected(*code);
    for (const std::string& word : generate) {
        const auto source = parse_source(word, request.growth);
        if (!source) return tl::unexpected(usage_error(verb, fmt::format("--generate: {}", source.error())));
        request.sources.push_back(*source);
    }
    if (!request.scene.scene.empty()) request.sources.push_back({request.scene.scene, nullptr, {0}, 1});
    if (const std::string why = why_not(request, generate); !why.empty()) return tl::unexpected(usage_error(verb, why));
    if (const std::string why = why_no_files(request); !why.empty()) return tl::unexpected(fail(why));
    return request;
}

}  // namespace alidade

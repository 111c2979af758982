// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/cycles_reference.h"

#include "core/fingerprint.h"
#include "core/image.h"
#include "tools/compare/cycles_job.h"
#include "tools/compare/kept_pictures.h"
#include "tools/compare/program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>

namespace alidade {

namespace fs = std::filesystem;

extern const std::string_view kCyclesScript;   // cycles.py

namespace {

constexpr const char* kScript = "cycles.py";
constexpr const char* kJob = "job.json";

tl::unexpected<RenderFailure> failure(std::string sentence) { return tl::unexpected(RenderFailure{false, true, std::move(sentence)}); }

/// Blender takes the folder that it works in from the environment, not from the system: so files have their whole names.
Words command(const std::string& folder) {
    return {"blender", "-b", "--factory-startup", "-noaudio", "-t", "1", "--python-exit-code", "1", "--python", folder + kScript, "--", folder + kJob};
}

/// Blender's Python takes the libraries of the first python3 on PATH, which must be the one beside Blender.
std::string search_path() {
    const char* path = std::getenv("PATH");
    return fmt::format("PATH={}:{}", fs::path(find_program("blender")).parent_path().string(), path ? path : "");
}

/// Stands for the script and all that it reads.
tl::expected<std::string, std::string> key_of(const std::string& job, const CompareJob& asked, const std::string& scratch) {
    uint64_t key = fingerprint(fmt::format("{}\n{}\n{}", blender_version(), kCyclesScript, job));
    for (const std::string& file : {asked.scene, scratch + "/sky.exr"}) {
        if (!fs::exists(file)) continue;
        const auto bytes = read_file(file);
        if (!bytes) return tl::unexpected(bytes.error());
        key = fingerprint(std::span(*bytes), key);
    }
    return fmt::format("{:016x}", key);
}

tl::expected<Rendered, RenderFailure> render(const CompareJob& job, const Json& told, const std::string& scratch) {
    for (const auto& [file, text] : {std::pair(kScript, std::string(kCyclesScript)), std::pair(kJob, told.dump())})
        if (const auto written = write_file(fmt::format("{}/{}", scratch, file), std::as_bytes(std::span(text))); !written) return failure(written.error());
    Words words = command(scratch + "/");
    words.insert(words.begin(), {"env", search_path(), "TMPDIR=" + scratch});   // what it leaves there when it is killed goes with the folder
    const auto run = run_program(words, scratch, job.timeout);
    if (!run) return failure(run.error());
    if (run->timed_out) return failure(fmt::format("Cycles made no picture in {} s", job.timeout));
    Rendered out{"", {}, command(""), run->cpu_seconds, false};
    for (const auto& name : told["pictures"]) {
        const std::string picture = fmt::format("{}/{}", scratch, name.get<std::string>());
        if (run->exit_code != 0 || !fs::exists(picture)) return failure(fmt::format("Cycles made no picture (exit code {}): {}", run->exit_code, complaint(run->output)));
        (out.picture.empty() ? out.picture : out.more.emplace_back()) = picture;
    }
    return out;
}

}  // namespace

tl::expected<Rendered, RenderFailure> cycles_reference(const CompareJob& job, const CompiledScene& scene, const std::string& scratch) {
    auto told = cycles_job(job, scene, scratch);
    if (!told) return failure(told.error());
    (*told)["scene"] = fs::relative(job.scene, scratch).string();
    const auto key = key_of(told->dump(), job, scratch);
    if (!key) return failure(key.error());
    const KeptPictures kept(job.cache, *key, ".exr", job.seeds);
    if (auto found = kept.find()) {
        found->command = command("");
        return *found;
    }
    auto rendered = render(job, *told, scratch);
    if (rendered) kept.keep(*rendered);
    return rendered;
}

const std::string& blender_version() {
    static const std::string version = program_version("blender", "Blender", 60);
    return version;
}

}  // namespace alidade

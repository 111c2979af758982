// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/povray_reference.h"

#include "core/fingerprint.h"
#include "core/image.h"
#include "tools/compare/kept_pictures.h"
#include "tools/compare/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace alidade {

namespace fs = std::filesystem;

namespace {

constexpr uint64_t kMostBytes = uint64_t(1) << 30;   // a folder that is larger is not one of scenes

tl::unexpected<RenderFailure> failure(bool reference, std::string sentence) { return tl::unexpected(RenderFailure{false, reference, std::move(sentence)}); }

fs::path folder_of(const std::string& scene) {
    const fs::path folder = fs::path(scene).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

bool same_folder(const fs::path& a, const std::string& b) {
    std::error_code ignored;
    return !b.empty() && fs::equivalent(a, b, ignored);
}

/// The files of a job below `folder`, sorted. Links to folders are followed, each folder once.
std::vector<fs::path> files_below(const CompareJob& job, const fs::path& folder, bool& too_large) {
    std::vector<fs::path> files;
    uint64_t bytes = 0;
    std::error_code ignored;
    std::set<fs::path> seen{fs::canonical(folder, ignored)};
    constexpr auto kHow = fs::directory_options::skip_permission_denied | fs::directory_options::follow_directory_symlink;
    for (fs::recursive_directory_iterator at(folder, kHow, ignored), end; at != end && bytes <= kMostBytes; at.increment(ignored)) {
        const bool left_out = same_folder(at->path(), job.cache) || same_folder(at->path(), job.results);
        if (at->is_directory(ignored) && (left_out || !seen.insert(fs::canonical(at->path(), ignored)).second)) at.disable_recursion_pending();
        if (at->is_regular_file(ignored)) files.push_back(at->path()), bytes += at->file_size(ignored);
    }
    too_large = bytes > kMostBytes;
    std::sort(files.begin(), files.end());
    return files;
}

/// In any case of letters; `word` is in lower case.
bool begins_with(const std::string& text, std::string_view word) {
    return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// What the scene is called in copies of its folder: POV-Ray takes no blanks, quotes or letters beyond ASCII after +I.
std::string name_in_copy(const CompareJob& job) {
    const std::string name = fs::path(job.scene).filename().string();
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-' || c == '+'; });
    return plain ? name : "alidade_compared_scene.pov";
}

/// The folders that a word, or a line of an .ini file, adds to POV-Ray's library.
void add_library(const fs::path& folder, const std::string& word, std::vector<fs::path>& out) {
    const size_t equal = word.find('=');
    if (begins_with(word, "+l") || begins_with(word, "-l")) out.push_back(folder / word.substr(2));   // an absolute one stays as it is
    if (begins_with(word, "library_path") && equal != word.npos) {
        std::string path = word.substr(equal + 1);
        std::erase_if(path, [](char c) { return c == '"' || c == '\r'; });
        path.erase(0, path.find_first_not_of(" \t"));
        out.push_back(folder / path);
    }
}

/// The file of a word that is an .ini, "file.ini" or "file.ini[section]", or "".
fs::path ini_of(const fs::path& folder, const std::string& word) {
    if (word.empty() || word[0] == '+' || word[0] == '-' || word.find('=') != word.npos) return {};
    const fs::path file = folder / word.substr(0, word.find('['));
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) ? file : fs::path();
}

tl::expected<std::string, std::string> copied_folder(const CompareJob& job, const std::string& scratch) {
    bool too_large = false;
    const fs::path from = folder_of(job.scene), to = fs::path(scratch) / "scene";
    const std::vector<fs::path> files = files_below(job, from, too_large);
    if (too_large) return tl::unexpected(fmt::format("the folder {} holds more than 1 GiB: a scene is rendered in a copy of its folder, so give it one of its own", from.string()));
    std::error_code error;
    for (const fs::path& file : files) {
        const fs::path copy = to / file.lexically_relative(from);
        fs::create_directories(copy.parent_path(), error);
        if (!fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error)) return tl::unexpected(fmt::format("cannot copy {}: {}", file.string(), error.message()));
    }
    const std::string name = name_in_copy(job);
    if (name != fs::path(job.scene).filename() && !fs::copy_file(job.scene, to / name, fs::copy_options::overwrite_existing, error))
        return tl::unexpected(fmt::format("cannot copy {}: {}", job.scene, error.message()));
    return to.string();
}

/// The picture that a program was asked for: under its name, or under that with the number of its only frame.
std::string produced(const std::string& output) {
    if (fs::exists(output)) return output;
    std::vector<std::string> found;
    const std::string stem = fs::path(output).stem().string();
    for (const auto& entry : fs::directory_iterator(fs::path(output).parent_path())) {
        const std::string name = entry.path().stem().string();
        const bool numbered = name.size() > stem.size() && name.rfind(stem, 0) == 0 && std::all_of(name.begin() + long(stem.size()), name.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (numbered && entry.path().extension() == ".png") found.push_back(entry.path().string());
    }
    return found.size() == 1 ? found[0] : "";
}

/// `program` in the copied folder.
tl::expected<Rendered, RenderFailure> render(const CompareJob& job, const std::string& folder, const std::string& output, Words program, bool reference) {
    for (const std::string& word : povray_words(job, output)) program.push_back(word);
    const auto run = run_program(program, folder, job.timeout);
    if (!run) return failure(reference, run.error());
    const char* name = reference ? "POV-Ray" : "alidade";
    if (run->timed_out) return failure(reference, fmt::format("{} made no picture in {} s", name, job.timeout));
    const std::string picture = produced(output);
    if (run->exit_code != 0 || picture.empty()) return failure(reference, fmt::format("{} made no picture (exit code {}): {}", name, run->exit_code, complaint(run->output)));
    return Rendered{picture, {}, std::move(program), run->cpu_seconds, false};
}

}  // namespace

Words povray_words(const CompareJob& job, const std::string& output) {
    Words words = job.words;
    for (const std::string& word : {"+I" + name_in_copy(job), fmt::format("+W{}", job.width), fmt::format("+H{}", job.height)}) words.push_back(word);
    const bool antialiased = std::any_of(job.words.begin(), job.words.end(), [](const std::string& word) { return begins_with(word, "+a") || begins_with(word, "antialias"); });
    if (!antialiased) words.emplace_back("-A");
    for (const std::string& word : {std::string("+WT1"), std::string("-D"), std::string("-P"), std::string("+FN8"), "+O" + output}) words.push_back(word);
    return words;
}

tl::expected<std::string, std::string> reference_key(const CompareJob& job) {
    uint64_t key = fingerprint(fmt::format("{} {}", job.against->name, job.against->version()));
    for (const std::string& word : povray_words(job, "")) key = fingerprint(word + '\0', key);
    std::vector<fs::path> folders{folder_of(job.scene)};
    for (const std::string& word : job.words) {
        add_library(folders[0], word, folders);
        const fs::path ini = ini_of(folders[0], word);
        if (ini.empty()) continue;
        std::ifstream lines(ini);
        for (std::string line; std::getline(lines, line); key = fingerprint(line + '\n', key)) add_library(folders[0], line, folders);
    }
    for (const fs::path& folder : folders) {
        bool too_large = false;
        for (const fs::path& file : files_below(job, folder, too_large)) {
            const auto bytes = read_file(file.string());
            if (!bytes) return tl::unexpected(bytes.error());
            key = fingerprint(std::span(*bytes), fingerprint(file.lexically_relative(folder).string() + '\0', key));
        }
        if (too_large) return tl::unexpected(fmt::format("the folder {} holds more than 1 GiB", folder.string()));
    }
    return fmt::format("{:016x}", key);
}

tl::expected<Rendered, RenderFailure> povray_reference(const CompareJob& job, const std::string& scratch) {
    if (!fs::is_regular_file(job.scene)) return failure(true, fmt::format("there is no file {}", job.scene));
    const auto key = reference_key(job);
    if (!key) return failure(true, key.error());
    const KeptPictures kept(job.cache, *key, ".png", 1);
    if (auto found = kept.find()) {
        found->command = {"povray"};
        for (const std::string& word : povray_words(job, "picture.png")) found->command.push_back(word);
        return *found;
    }
    const auto folder = copied_folder(job, scratch);
    if (!folder) return failure(true, folder.error());
    auto rendered = render(job, *folder, scratch + "/picture.png", {"povray"}, true);
    if (rendered) kept.keep(*rendered);
    return rendered;
}

tl::expected<Rendered, RenderFailure> povray_test(const CompareJob& job, const std::string& scratch) {
    const auto folder = copied_folder(job, scratch);
    if (!folder) return failure(false, folder.error());
    auto all = render(job, *folder, scratch + "/picture.png", {own_program(), "povray"}, false);
    for (int seed = 1; all && seed < job.seeds; ++seed) {
        const std::string own = fmt::format("{}/seed{}", scratch, seed);   // a folder of its own: the picture's name may get a number
        std::error_code error;
        if (!fs::create_directory(own, error)) return failure(false, fmt::format("cannot make the folder {}: {}", own, error.message()));
        const auto one = render(job, *folder, own + "/picture.png", {own_program(), "povray", fmt::format("--seed={}", seed)}, false);
        if (!one) return one;
        all->more.push_back(one->picture), all->cpu_seconds += one->cpu_seconds;
    }
    return all;
}

const std::string& povray_version() {
    static const std::string version = program_version("povray", "POV-Ray", 20);
    return version;
}

}  // namespace alidade

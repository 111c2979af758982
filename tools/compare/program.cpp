// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/program.h"

#include "tools/verbs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

extern char** environ;

namespace alidade {

namespace fs = std::filesystem;

namespace {

/// What an interruption has to clear away.
struct Alive {
    std::mutex mutex;
    std::set<pid_t> programs;
    std::set<std::string> folders;
};

/// Never destroyed: the thread that waits for signals may outlive main().
Alive& alive() {
    static Alive* all = new Alive;
    return *all;
}

/// Waits for a signal, clears away and ends the process. The lock is kept: nothing new begins.
[[noreturn]] void end_on(const sigset_t& signals) {
    int signal = 0;
    sigwait(&signals, &signal);
    Alive& all = alive();
    const std::scoped_lock lock(all.mutex);
    for (const pid_t program : all.programs) ::kill(-program, SIGKILL);
    for (const pid_t program : all.programs) waitpid(program, nullptr, 0);
    std::error_code ignored;
    for (const std::string& folder : all.folders) fs::remove_all(folder, ignored);
    constexpr std::string_view kText = "alidade: interrupted\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText.data(), kText.size());
    _exit(kInterrupted);
}

/// How the process is started: its streams, its folder, and a group of its own, so that what it starts ends with it.
class Start {
  public:
    Start(const std::string& folder, const std::string& log) {
        posix_spawn_file_actions_init(&actions_), posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
        sigset_t none;   // this process may wait for its signals; a program has to hear them
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
        posix_spawnattr_setpgroup(&attributes_, 0);
    }
    ~Start() { posix_spawn_file_actions_destroy(&actions_), posix_spawnattr_destroy(&attributes_); }
    Start(const Start&) = delete;

    tl::expected<pid_t, std::string> run(const std::vector<std::string>& words) const {
        std::vector<char*> argv;
        for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
        pid_t pid = 0;
        const std::scoped_lock lock(alive().mutex);
        const int error = posix_spawnp(&pid, argv[0], &actions_, &attributes_, argv.data(), environ);
        if (error) return tl::unexpected(fmt::format("cannot run {}: {}", words[0], std::strerror(error)));
        alive().programs.insert(pid);
        return pid;
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

void wait_for(pid_t pid, double timeout, ProgramRun& run) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
    int status = 0;
    rusage usage{};
    while (wait4(pid, &status, WNOHANG, &usage) == 0) {
        if (Clock::now() < end) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            continue;
        }
        run.timed_out = true;
        ::kill(-pid, SIGKILL);
        wait4(pid, &status, 0, &usage);
        break;
    }
    {
        const std::scoped_lock lock(alive().mutex);
        alive().programs.erase(pid);
    }
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string end_of_file(const std::string& path) {
    constexpr std::streamoff kMost = 65536;
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) return {};
    const std::streamoff size = file.tellg();
    file.seekg(std::max<std::streamoff>(0, size - kMost));
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

tl::expected<ProgramRun, std::string> run_program(const std::vector<std::string>& words, const std::string& folder, double timeout_seconds) {
    const ScratchFolder scratch;
    const std::string log = scratch.path() + "/log";
    const auto pid = Start(folder, log).run(words);
    if (!pid) return tl::unexpected(pid.error());
    ProgramRun run;
    wait_for(*pid, timeout_seconds, run);
    run.output = end_of_file(log);
    return run;
}

std::string complaint(const std::string& output) {
    std::string last, found;
    for (size_t begin = 0; begin < output.size();) {
        const size_t end = std::min(output.find('\n', begin), output.size());
        std::string line = output.substr(begin, end - begin);
        begin = end + 1;
        line.erase(std::remove_if(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), line.end());
        if (line.find_first_not_of(' ') == line.npos) continue;
        last = line;
        if (found.empty() && (line.find("rror:") != line.npos || line.find("rror ") != line.npos)) found = line;
    }
    return found.empty() ? last : found;
}

std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "";
    while (!rest.empty()) {
        const size_t colon = std::min(rest.find(':'), rest.size());
        const std::string candidate = rest.substr(0, colon) + "/" + name;
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0) return candidate;
        rest.erase(0, std::min(colon + 1, rest.size()));
    }
    return {};
}

std::string program_version(const std::string& name, const std::string& title, double timeout_seconds) {
    if (find_program(name).empty()) return {};
    const auto run = run_program({name, "--version"}, ".", timeout_seconds);
    const size_t at = run ? run->output.find(title + " ") : std::string::npos;
    if (at == std::string::npos) return "unknown";
    const size_t from = at + title.size() + 1;
    return run->output.substr(from, run->output.find_first_of(" \n", from) - from);
}

std::string own_program() { return fs::read_symlink("/proc/self/exe").string(); }

void clean_up_on_signal() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([signals] { end_on(signals); }).detach();
}

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "alidade-XXXXXX").string();
    const std::scoped_lock lock(alive().mutex);
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make a temporary folder");
    path_ = name;
    alive().folders.insert(path_);
}

ScratchFolder::~ScratchFolder() {
    const std::scoped_lock lock(alive().mutex);
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    alive().folders.erase(path_);
}

}  // namespace alidade

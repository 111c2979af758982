// SPDX-License-Identifier: Apache-2.0
/// Other programs, run as processes of their own.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

struct ProgramRun {
    int exit_code = 0;         ///< 128 + the signal that ended it
    bool timed_out = false;    ///< and was killed, with what it had started
    double cpu_seconds = 0;    ///< user and system, with its children
    std::string output;        ///< the end of what it wrote to both streams, at most 64 KiB
};

/// Runs words[0], found along PATH, in `folder`, with an empty standard input. An error says why it could not be started.
tl::expected<ProgramRun, std::string> run_program(const std::vector<std::string>& words, const std::string& folder, double timeout_seconds);

/// The line of a program's output that says what went wrong, else its last.
std::string complaint(const std::string& output);

/// Where PATH has a program of this name, or "".
std::string find_program(const std::string& name);
/// What `name --version` says after `title`; "" if it is not installed, "unknown" if it says nothing of the kind within `timeout_seconds`.
std::string program_version(const std::string& name, const std::string& title, double timeout_seconds);
/// This program's own file.
std::string own_program();

/// From now on SIGINT, SIGTERM and SIGHUP kill the programs that run, with what they have started, remove all scratch folders, and end this process with
/// the exit code of an interruption. To be called before other threads are started.
void clean_up_on_signal();

/// A folder for what is thrown away at the end of the scope, or at the end of the program (clean_up_on_signal).
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Messages for people: where, what, the line with a caret, what to do. Input can be wrong in many places at once, so they are collected.
#pragma once

#include "core/source.h"

#include <string>
#include <utility>
#include <vector>

namespace alidade {

enum class Severity { note, warning, error };

/// Where a file was included, or a macro was called.
struct Caller {
    SourcePos at;
    std::string macro;   ///< its name; empty: an #include
};

struct Diagnostic {
    Severity severity = Severity::error;
    SourcePos at;
    std::string message;               ///< one line, no full stop
    std::string hint;                  ///< what to do about it; may be empty
    std::string excerpt;               ///< the source line that `at` names; may be empty
    std::vector<Caller> called_from;   ///< innermost first
};

class Diagnostics {
  public:
    /// Only this many errors, warnings and notes each are kept; the rest is counted (a broken file of a million lines must not fill memory).
    static constexpr size_t kKept = 100;

    uint32_t add_file(std::string path);
    void add(Diagnostic d);
    void error(SourcePos at, std::string message, std::string hint = {}) { add({Severity::error, std::move(at), std::move(message), std::move(hint), {}, {}}); }
    void warning(SourcePos at, std::string message, std::string hint = {}) { add({Severity::warning, std::move(at), std::move(message), std::move(hint), {}, {}}); }
    void note(SourcePos at, std::string message, std::string hint = {}) { add({Severity::note, std::move(at), std::move(message), std::move(hint), {}, {}}); }
    /// Appends what `other` says; its files keep their paths.
    void append(const Diagnostics& other);

    bool has_errors() const { return errors_ > 0; }
    size_t errors() const { return errors_; }
    size_t warnings() const { return warnings_; }
    const std::vector<Diagnostic>& list() const { return list_; }
    const std::vector<SourceFile>& files() const { return files_; }

    /// `path:line:col: error: message`, the excerpt with a caret, `hint: ...`, the stack of includes and macro calls; a JSON pointer stands as `path:/pointer: error: ...`.
    std::string text(const Diagnostic& d) const;
    /// All of them, and how many were left out.
    std::string text() const;
    std::string where(const SourcePos& at) const;

  private:
    std::vector<Diagnostic> list_;
    std::vector<SourceFile> files_;
    size_t errors_ = 0, warnings_ = 0, notes_ = 0;
};

}  // namespace alidade

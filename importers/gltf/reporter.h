// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/diagnostics.h"

#include <set>
#include <string>

namespace alidade::gltf {

/// The messages about one glTF file, each at a JSON pointer.
class Reporter {
  public:
    Reporter(const std::string& path, bool strict) : strict_(strict) { file_ = diagnostics_.add_file(path); }

    SourcePos at(std::string pointer) const { return {file_, 0, 0, std::move(pointer)}; }
    void error(std::string pointer, std::string message, std::string hint = {}) {
        diagnostics_.error(at(std::move(pointer)), std::move(message), std::move(hint));
    }
    void warning(std::string pointer, std::string message, std::string hint = {}) {
        diagnostics_.warning(at(std::move(pointer)), std::move(message), std::move(hint));
    }
    void note(std::string pointer, std::string message) { diagnostics_.note(at(std::move(pointer)), std::move(message)); }
    /// The picture may differ because the file asks for something that is not understood: a warning, or an error where the user asked for strictness.
    void not_understood(std::string pointer, std::string message, std::string hint = {});
    /// As not_understood(), once for each extension.
    void extension_ignored(std::string pointer, const std::string& name);
    void add(Diagnostic d) { diagnostics_.add(std::move(d)); }

    uint32_t file() const { return file_; }
    bool failed() const { return diagnostics_.has_errors(); }
    const Diagnostics& diagnostics() const { return diagnostics_; }

  private:
    Diagnostics diagnostics_;
    uint32_t file_ = 0;
    bool strict_ = false;
    std::set<std::string> ignored_;
};

}  // namespace alidade::gltf

// SPDX-License-Identifier: Apache-2.0
#include "core/diagnostics.h"

#include <fmt/format.h>

namespace alidade {

uint32_t Diagnostics::add_file(std::string path) {
    for (size_t i = 0; i < files_.size(); ++i)
        if (files_[i].path == path) return uint32_t(i);
    files_.push_back({std::move(path)});
    return uint32_t(files_.size() - 1);
}

void Diagnostics::add(Diagnostic d) {
    size_t& count = d.severity == Severity::error ? errors_ : d.severity == Severity::warning ? warnings_ : notes_;
    if (count++ < kKept) list_.push_back(std::move(d));
}

void Diagnostics::append(const Diagnostics& other) {
    for (Diagnostic d : other.list_) {
        auto moved = [&](SourcePos& at) { at.file = at.file < other.files_.size() ? add_file(other.files_[at.file].path) : kNoFile; };
        moved(d.at);
        for (Caller& caller : d.called_from) moved(caller.at);
        add(std::move(d));
    }
    auto left_out = [](size_t n) { return n > kKept ? n - kKept : 0; };
    errors_ += left_out(other.errors_), warnings_ += left_out(other.warnings_), notes_ += left_out(other.notes_);
}

std::string Diagnostics::where(const SourcePos& at) const {
    std::string out = at.file < files_.size() ? files_[at.file].path : std::string("alidade");
    if (at.line) out += fmt::format(":{}", at.line);
    if (at.line && at.column) out += fmt::format(":{}", at.column);
    if (!at.pointer.empty()) out += ":" + at.pointer;
    return out;
}

std::string Diagnostics::text(const Diagnostic& d) const {
    static constexpr const char* kName[] = {"note", "warning", "error"};
    std::string out = fmt::format("{}: {}: {}\n", where(d.at), kName[int(d.severity)], d.message);
    if (!d.excerpt.empty()) {
        out += fmt::format("    {}\n", d.excerpt);
        if (d.at.column) out += fmt::format("    {:>{}}\n", "^", d.at.column);
    }
    if (!d.hint.empty()) out += fmt::format("hint: {}\n", d.hint);
    for (const Caller& caller : d.called_from)
        out += caller.macro.empty() ? fmt::format("    included from {}\n", where(caller.at)) : fmt::format("    in macro {}, called from {}\n", caller.macro, where(caller.at));
    return out;
}

std::string Diagnostics::text() const {
    std::string out;
    for (const Diagnostic& d : list_) out += text(d);
    if (errors_ > kKept) out += fmt::format("... and {} more errors\n", errors_ - kKept);
    if (warnings_ > kKept) out += fmt::format("... and {} more warnings\n", warnings_ - kKept);
    if (notes_ > kKept) out += fmt::format("... and {} more notes\n", notes_ - kKept);
    return out;
}

}  // namespace alidade

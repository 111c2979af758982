// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/reporter.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade::mesh {

SourcePos Reporter::place(const TextCursor::Mark& at) const { return {file_, at.line, at.column(), {}}; }

void Reporter::say(Severity severity, const TextCursor::Mark& at, std::string message, std::string hint) {
    said_.add({severity, place(at), std::move(message), std::move(hint), cursor_.line_at(at), {}});
}

void Reporter::error(const TextCursor::Mark& at, std::string message, std::string hint) { say(Severity::error, at, std::move(message), std::move(hint)); }
void Reporter::warning(const TextCursor::Mark& at, std::string message, std::string hint) { say(Severity::warning, at, std::move(message), std::move(hint)); }

void Reporter::tally(const TextCursor::Mark& at, const std::string& message) {
    constexpr size_t kMost = 40;   // different messages; a file of random words must not fill memory
    const auto known = std::find_if(tallies_.begin(), tallies_.end(), [&](const Tally& t) { return t.message == message; });
    if (known != tallies_.end()) ++known->count;
    else if (tallies_.size() < kMost) tallies_.push_back({message, at, 1});
    else if (tallies_.size() == kMost) tallies_.push_back({"more of the kind", at, 1});
    else ++tallies_.back().count;
}

void Reporter::tell_tallies() {
    for (Tally& t : tallies_) {
        if (t.count > 1) t.message += fmt::format(" ({} times)", t.count);
        say(strict_ ? Severity::error : Severity::warning, t.first, std::move(t.message), {});
    }
    tallies_.clear();
}

}  // namespace alidade::mesh

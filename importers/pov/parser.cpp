// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/parser.h"

#include "importers/pov/directives.h"
#include "importers/pov/macros.h"
#include "importers/pov/object_queries.h"
#include "importers/pov/space_functions.h"

#include <fmt/format.h>

namespace alidade::pov {

Parser::Parser(const ReadOptions& given, Diagnostics& diagnostics) : options(given), said(diagnostics), finder({}, {}) {}

Parser::~Parser() = default;

void Parser::check_budget(Place at) const {
    if (stream.tokens_read() + charged_ > options.limits.tokens_read)
        fail_limit(at, &Limits::tokens_read, fmt::format("the scene has made more than {} steps: does a loop never end?", options.limits.tokens_read));
}

void Parser::charge(uint64_t steps, Place at) {
    charged_ += steps;
    check_budget(at);
}

Macro* Parser::macro_of(const Token& token) const {
    const Slot* slot = token.kind == TokenKind::name ? symbols.find(token.id) : nullptr;
    return slot && slot->value.kind == Kind::macro ? &slot->value.as<Macro>() : nullptr;
}

/// The end of what is read just now, as a token where that ends.
Token Parser::end_of_frame() {
    Token end;
    end.source = stream.frame().source, end.offset = stream.frame().tokens[stream.frame().end].offset;
    return end;
}

/// With a hint also for what other languages say.
void Parser::fail_no_directive(const Token& hashed) const {
    const std::string_view text = names.text(hashed.id);
    static constexpr std::pair<std::string_view, std::string_view> kElsewhere[] = {{"endif", "end"}, {"elif", "elseif"}, {"elsif", "elseif"}, {"define", "declare"}};
    std::string_view meant = names.nearest(text, [](WordId id) { return id < kWordCount && is_directive(id); });
    for (const auto& [elsewhere, here] : kElsewhere)
        if (text == elsewhere) meant = here;
    fail_limit(hashed.place(), fmt::format("there is no directive #{}", text), meant.empty() ? "" : fmt::format("did you mean #{}?", meant));
}

/// What a directive has looked at and left comes before the next token of the stream.
Token Parser::resolve(Token token, Waiting waiting) {
    for (;; token = stream.raw()) {
        switch (token.kind) {
            case TokenKind::directive:
                if (waiting == Waiting::directives || (waiting == Waiting::declarations && (token.directive.word == "declare"_w || token.directive.word == "local"_w))) return token;
                check_budget(token.place());
                obey(*this, token);
                break;
            case TokenKind::hashed:
                if (!symbols.find(token.id)) fail_no_directive(token);
                token.kind = TokenKind::name;
                [[fallthrough]];
            case TokenKind::name: {
                Macro* macro = macro_of(token);
                if (!macro || waiting != Waiting::nothing) return token;
                check_budget(token.place());
                call_macro(*this, token, Ref<Macro>(macro));
                break;
            }
            case TokenKind::bad: fail_limit(token.place(), text(token));
            case TokenKind::end:
                if (stream.frames().size() == 1 && !stream.frame_has_conditions()) return end_of_frame();
                finish_frame();
                break;
            default: return token;
        }
        if (has_ahead_) {
            has_ahead_ = false;
            return ahead_;
        }
    }
}

/// The end of a macro's body or of an include.
void Parser::finish_frame() {
    const Frame& frame = stream.frame();
    if (stream.frame_has_conditions()) {
        const Token& opened = frame.tokens[stream.conditions().back().opened];
        fail_limit(opened.place(), fmt::format("#{} has no #end", kWords[opened.directive.word]));
    }
    stream.pop();
    symbols.leave();
}

Token Parser::peek_within(Waiting waiting) {
    if (has_ahead_) return ahead_;
    const Token token = resolve(stream.raw(), waiting);
    if (token.kind == TokenKind::directive || macro_of(token)) --stream.frame().at;
    else put_back(token);
    return token;
}

Token Parser::expect(char mark, const char* where) {
    const Token token = next();
    if (!token.is(mark)) fail(token.place(), fmt::format("{} is expected {}, not {}", mark, where, describe(token)));
    return token;
}

Token Parser::raw_token() {
    if (has_ahead_) {
        has_ahead_ = false;
        return ahead_;
    }
    const Token token = stream.raw();
    if (token.kind == TokenKind::bad) fail_limit(token.place(), text(token));
    return token.kind == TokenKind::end ? end_of_frame() : token;
}

Value Parser::vector(const Token& token) const {
    const std::span<const double> numbers = stream.vector(token);
    Value v = Value::vector(uint8_t(numbers.size()), {});
    std::copy(numbers.begin(), numbers.end(), v.c.begin());
    return v;
}

std::string Parser::describe(const Token& token) const {
    switch (token.kind) {
        case TokenKind::end: return "the end of the text";
        case TokenKind::number: return fmt::format("the number {}", token.number);
        case TokenKind::vector: return fmt::format("the vector <{}>", fmt::join(stream.vector(token), ", "));
        case TokenKind::string: return fmt::format("the string \"{}\"", text(token).substr(0, 40));
        case TokenKind::word: case TokenKind::name: return std::string(names.text(token.id));
        case TokenKind::hashed: return fmt::format("#{}", names.text(token.id));
        case TokenKind::directive: return fmt::format("#{}", kWords[token.directive.word]);
        case TokenKind::mark: return token.mark == kLessEqual ? "<=" : token.mark == kGreaterEqual ? ">=" : token.mark == kNotEqual ? "!=" : std::string(1, token.mark);
        case TokenKind::bad: return text(token);
    }
    return {};
}

Diagnostic Parser::diagnostic(Severity severity, Place at, std::string message, std::string hint) const {
    Diagnostic d{severity, {}, std::move(message), std::move(hint), {}, {}};
    if (at.source >= stream.sources()) return d;
    const Source& source = stream.source(uint16_t(at.source));
    d.at = source.position(at.offset);
    uint32_t column = 0;
    d.excerpt = source.excerpt(at.offset, column);
    if (column != d.at.column) d.excerpt.clear();          // a caret would stand at the wrong place in the cut line
    constexpr size_t kShown = 8;
    const std::vector<Frame>& frames = stream.frames();
    for (size_t i = frames.size(); i-- > 1 && d.called_from.size() < kShown;) {
        SourcePos caller = stream.source(uint16_t(frames[i].called_from.source)).position(frames[i].called_from.offset);
        d.called_from.push_back({std::move(caller), frames[i].macro ? std::string(names.text(frames[i].macro->name)) : std::string()});
    }
    return d;
}

void Parser::fail(Place at, std::string message, std::string hint) const {
    throw Failure{diagnostic(Severity::error, at, std::move(message), std::move(hint)), false};
}

void Parser::fail_unmodelled(Place at, std::string message, std::string hint) const {
    throw Failure{diagnostic(Severity::error, at, std::move(message), std::move(hint)), false, false, true};
}

void Parser::fail_limit(Place at, std::string message, std::string hint) const {
    throw Failure{diagnostic(Severity::error, at, std::move(message), std::move(hint)), true};
}

void Parser::warn(Place at, std::string message, std::string hint) {
    const std::pair<uint64_t, std::string> key{uint64_t(at.source) << 32 | at.offset, message};
    if (warned_.size() > Diagnostics::kKept || std::find(warned_.begin(), warned_.end(), key) != warned_.end()) return;
    warned_.push_back(key);
    said.add(diagnostic(Severity::warning, at, std::move(message), std::move(hint)));
}

void Parser::report(Diagnostic error) {
    const auto same = [&](const Diagnostic& d) {
        const bool here = d.at.file == error.at.file && d.at.line == error.at.line && d.at.column == error.at.column;
        return here && d.severity == error.severity && d.message == error.message;
    };
    if (std::none_of(said.list().begin(), said.list().end(), same)) said.add(std::move(error));
}

void Parser::tally(Place at, const std::string& message) {
    for (Tally& tally : tallies_)
        if (tally.message == message) {
            ++tally.count;
            return;
        }
    tallies_.push_back({message, at, 1});
}

void Parser::say_tallies() {
    for (const Tally& tally : tallies_)
        warn(tally.first, tally.count > 1 ? fmt::format("{} ({} times)", tally.message, tally.count) : tally.message);
}

Value Parser::string(const Token& token) {
    if (charset == Charset::system) fail(token.place(), "POV-Ray 3.7 refuses strings behind charset sys", "write charset utf8, or leave it out");
    const std::string* blanked = charset == Charset::ascii ? stream.blanked(token) : nullptr;
    if (!blanked) return Value::string(text(token));
    warn(token.place(), "what is not ASCII in a string is blanks, as in POV-Ray", "write global_settings { charset utf8 } before it, or \\u and four hexadecimal digits");
    return Value::string(*blanked);
}

void Parser::print(TextStream where, Place at, const std::string& text) {
    const bool warning = where == TextStream::warning;
    constexpr uint64_t kStepsOfPrinting = 64;   // a line of a console takes as long as so many tokens: endless loops end within seconds
    charge(kStepsOfPrinting, at);
    if (options.print) options.print(where, text);
    if (options.print && !warning) return;
    std::string line = text.substr(0, text.find_last_not_of(" \n\r\t") + 1);
    if (!line.empty()) said.add(diagnostic(warning ? Severity::warning : Severity::note, at, std::move(line), {}));
}

void Parser::open_scene(const std::string& path, std::string text) {
    finder = SourceFinder(std::filesystem::path(path).parent_path(), options.include_paths, options.scene_folder_last);
    const uint16_t source = stream.add(Source(path, std::move(text), said.add_file(path)), names, options.limits);
    warn_of_nuls(source);
    stream.push_file(source, {});
}

void Parser::warn_of_nuls(uint16_t source) {
    const size_t nul = stream.source(source).text().find('\0');
    if (nul != std::string_view::npos) warn({source, uint32_t(nul)}, "a byte 0 is taken as a blank, as in POV-Ray: is this a text file?");
}

namespace {

/// The name of a file beside those that were looked for which is spelt nearly so; empty if there is none.
std::string file_meant(const SourceFinder& finder, const std::string& name) {
    constexpr size_t kFarthest = 2;
    size_t least = std::min(kFarthest, name.size() / 3) + 1;
    std::string meant;
    const std::filesystem::path below = std::filesystem::path(name).parent_path(), asked = std::filesystem::path(name).filename();
    for (const std::filesystem::path& folder : finder.folders()) {
        std::error_code failed;
        for (std::filesystem::directory_iterator at(folder / below, failed), end; !failed && at != end; at.increment(failed)) {
            const std::string there = at->path().filename().string();
            const size_t far = edit_distance(asked.string(), there);
            if ((far < least || (far == least && !meant.empty() && there < meant)) && finder.find((below / there).string())) least = far, meant = there;
        }
    }
    return meant.empty() ? "" : (below / meant).string();
}

}  // namespace

std::string Parser::path_of_include(const std::string& name, Place at) {
    std::optional<SourceFinder::Found> found;
    if (!std::filesystem::path(name).has_extension()) found = finder.find(name + ".inc");   // POV-Ray prefers it (by experiment)
    if (!found || found->other_case)
        if (auto as_said = finder.find(name); as_said && !(found && as_said->other_case)) found = std::move(as_said);
    if (!found && options.write_folder)
        if (const auto own = TextFiles::below(*options.write_folder, name); own && files.wrote(*own)) return *own;
    if (!found || (found->other_case && options.strict)) {
        const bool installed = std::filesystem::exists(kStandardIncludes);
        if (const std::string meant = found ? "" : file_meant(finder, name); !meant.empty()) fail_limit(at, fmt::format("the file {} is not found", name), fmt::format("did you mean {}?", meant));
        fail_limit(at, fmt::format("the file {} is not found", name),
                   installed ? "say where it lies with -I DIR (alidade povray: +LDIR)" : "POV-Ray's own includes are in the package povray-includes; other folders are given with -I DIR (alidade povray: +LDIR)");
    }
    if (found->other_case) warn(at, fmt::format("the file {} is not found, {} is taken", name, found->path));
    return found->path;
}

uint16_t Parser::lexed(const std::string& path, const std::string* kept, Place at) {
    const auto known = lexed_.find(path);
    if (known != lexed_.end() && !kept && !files.wrote(path)) return known->second;
    std::optional<std::string> text = kept ? std::optional(*kept) : read_whole(path, options.limits.file_bytes);
    if (!text) fail_limit(at, fmt::format("the file {} cannot be read", path));
    if (known != lexed_.end() && stream.source(known->second).text() == *text) return known->second;
    if (stream.sources() >= 60000) fail_limit(at, "the scene includes more than 60000 files");
    const uint16_t source = stream.add(Source(path, std::move(*text), said.add_file(path)), names, options.limits);
    warn_of_nuls(source);
    return lexed_[path] = source;
}

/// What the scene has written itself comes first.
void Parser::include(const std::string& name, Place at) {
    files.flush();
    const std::string* kept = files.kept(name);
    const std::string path = kept ? name : path_of_include(name, at);
    if (symbols.depth() >= options.limits.levels) fail_limit(at, &Limits::levels, fmt::format("more than {} files and macros include or call one another", options.limits.levels));
    stream.push_file(lexed(path, kept, at), at);
    symbols.enter();
}

void Parser::check_array_elements(uint64_t more, Place at) const {
    if (more > options.limits.array_elements || elements->used + more > options.limits.array_elements)
        fail_limit(at, &Limits::array_elements, fmt::format("the arrays have more than {} elements", options.limits.array_elements));
}

void Parser::check_depth(const Value& value, Place at) const {
    if (value.shared && value.shared->depth > options.limits.depth) fail_limit(at, &Limits::depth, fmt::format("objects or functions are made of one another too deeply: more than {} levels", options.limits.depth));
}

void Parser::check_items(Place at) const {
    if (items->used >= options.limits.items) fail_limit(at, &Limits::items, fmt::format("the scene has more than {} words and values in its blocks", options.limits.items));
}

}  // namespace alidade::pov

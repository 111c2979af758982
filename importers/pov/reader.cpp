// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/reader.h"

#include "importers/pov/blocks.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/declared.h"
#include "importers/pov/directives.h"
#include "importers/pov/expressions.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// Errors after which reading ends: most of what follows would be caused by those before.
constexpr size_t kMostErrors = 10;
/// The same for those that were said before, at other turns of a loop.
constexpr size_t kMostFailures = 1000;

class Reader {
  public:
    explicit Reader(Parser& parser) : p_(parser) {}

    Program run(const std::string& path, std::string text) {
        attempt([&] {
            p_.open_scene(path, std::move(text));
            for (const std::string& declaration : p_.options.declarations) declare(declaration);
            predeclare(p_);
            if (p_.options.version) p_.version = std::clamp(*p_.options.version, 0.0, 3.7), p_.version_given = true;
            if (!p_.options.header.empty()) p_.include(p_.options.header, {});
        });
        while (!done_ && p_.said.errors() < kMostErrors && failures_ < kMostFailures) {
            attempt([&] { statement(); });
            take_settings();
        }
        if (const auto failed = p_.files.flush()) p_.said.error({}, fmt::format("the file {} cannot be written", *failed));
        for (const auto& [place, block] : p_.defaults) program_.defaults.push_back(block);
        for (size_t i = 0; i < p_.stream.sources(); ++i) program_.files.push_back({p_.stream.source(uint16_t(i)).path()});
        return std::move(program_);
    }

  private:
    template <class Step>
    void attempt(Step step) {
        try {
            step();
        } catch (Failure& failure) {
            if (!failure.follows) p_.report(std::move(failure.diagnostic));
            ++failures_;
            done_ = done_ || failure.fatal || p_.stream.frames().empty();
            if (!done_) recover();
        } catch (const std::bad_alloc&) {
            p_.said.error({}, "there is not enough memory for this scene");
            done_ = true;
        }
    }

    /// NAME=VALUE of the command line: the first of a name holds, with six significant digits, as in POV-Ray.
    void declare(const std::string& text) {
        const auto declared = parse_declared(text);
        const WordId name = declared ? p_.names.id(declared->name) : 0;
        if (name < kWordCount) throw Failure{{Severity::error, {}, fmt::format("{} declares nothing", text), "give an identifier that is no word of the language, = and a number that a float can hold", {}, {}}, true};
        if (!p_.symbols.find(name)) p_.symbols.global(name).value = Value::number(six_digits(declared->value));
    }

    /// Some directives are obeyed without their #, as by POV-Ray.
    bool is_old_directive(const Token& token) const {
        const bool setting = token.is_word("version"_w) || token.is_word("max_trace_level"_w) || token.is_word("max_intersections"_w);
        return token.is_word("default"_w) || token.is_word("declare"_w) || token.is_word("include"_w) || (setting && !p_.peek().is('{'));
    }
    void obey_old(const Token& word) {
        Token directive = word;
        directive.kind = TokenKind::directive;
        directive.directive = {uint16_t(word.id), 0, kOpen};
        obey(p_, directive);
    }

    /// `Ball`, `Balls[2]`: an `object { Ball }`.
    bool take_declared(const Token& name) {
        const Ref<Slot> slot = parse_reference(p_, name, false);      // says what is not declared
        if (!slot || slot->value.kind != Kind::block) return false;
        p_.check_items(name.place());
        OpenItem named;
        named.kind = Item::Kind::value, named.place = name.place(), named.value = slot->value;
        const Ref<Block> block = Block::of({&named, 1}, p_.items);
        block->word = "object"_w, block->place = name.place(), block->stands(p_.standing());
        program_.blocks.push_back(block);
        return true;
    }

    void take_charset(const Block& settings) {
        const std::span<const Item> items = settings.items();
        const auto is_word = [&](size_t i, WordId word) { return items[i].kind == Item::Kind::word && items[i].word == word; };
        for (size_t i = 1; i < items.size(); ++i)
            if (is_word(i - 1, "charset"_w)) p_.charset = is_word(i, "utf8"_w) ? Charset::utf8 : is_word(i, "sys"_w) ? Charset::system : Charset::ascii;
    }

    /// Pictures that are read from here on become what it says.
    void take_gamma(const Block& settings) {
        const std::span<const Item> items = settings.items();
        const auto is_gamma = [](const Item& item) { return item.kind == Item::Kind::word && item.word == "assumed_gamma"_w; };
        p_.gamma_given = p_.gamma_given || std::any_of(items.begin(), items.end(), is_gamma);
    }

    void statement() {
        const Token token = p_.next();
        if (token.kind == TokenKind::end) {
            done_ = true;
            return;
        }
        if (is_old_directive(token)) return obey_old(token);
        if (token.kind == TokenKind::name && take_declared(token)) return;
        if (token.kind == TokenKind::word && (is_object(token.id) || token.id == "camera"_w) && !p_.peek().is('{')) p_.fail(p_.peek().place(), fmt::format("{{ is expected behind {}, not {}", kWords[token.id], p_.describe(p_.peek())));
        if (token.kind != TokenKind::word || !p_.peek().is('{')) p_.fail(token.place(), fmt::format("an object or a directive is expected, not {}", p_.describe(token)));
        Value block = parse_block(p_, token.id, token.place());
        if (token.id == "global_settings"_w) take_charset(block.as<Block>()), take_gamma(block.as<Block>()), p_.globals.push_back(std::move(block));
        else program_.blocks.emplace_back(&block.as<Block>());
    }

    /// Those of blocks and of directives take their places among what else the scene holds.
    void take_settings() {
        for (; settings_ < p_.globals.size(); ++settings_) program_.blocks.emplace_back(&p_.globals[settings_].as<Block>());
    }

    /// After an error: leaves macros, and goes on at the next directive or word that begins a line.
    void recover() {
        p_.reset_nesting();
        while (p_.stream.frame().macro && p_.stream.frames().size() > 1) p_.stream.pop(), p_.symbols.leave();
        Frame& frame = p_.stream.frame();
        const std::string_view text = p_.stream.source(frame.source).text();
        for (; frame.at < frame.end; ++frame.at) {
            const Token& token = frame.tokens[frame.at];
            const bool begins_line = token.offset == 0 || text[token.offset - 1] == '\n';
            if (begins_line && (token.kind == TokenKind::directive || token.kind == TokenKind::word)) return;
            if (token.kind != TokenKind::directive) continue;
            if (const WordId word = token.directive.word; word == "end"_w || word == "else"_w || word == "elseif"_w || word == "case"_w || word == "range"_w) {
                if (p_.stream.frame_has_conditions()) return;
            } else if (word == "if"_w || word == "ifdef"_w || word == "ifndef"_w || word == "while"_w || word == "for"_w || word == "switch"_w || word == "macro"_w) {
                skip_structure(frame);
            }
        }
    }

    /// To the #end of the structure that begins here.
    static void skip_structure(Frame& frame) {
        uint32_t at = frame.at;
        while (at < frame.end && (at == frame.at || frame.tokens[at].directive.word != "end"_w)) at = std::min(frame.tokens[at].directive.next, frame.end);
        frame.at = std::min(at, frame.end - 1);
    }

    Parser& p_;
    Program program_;
    bool done_ = false;
    size_t failures_ = 0;
    size_t settings_ = 0;          ///< how many of the parser's are in the program
};

}  // namespace

Program read_program(Parser& parser, const std::string& path, std::string text) { return Reader(parser).run(path, std::move(text)); }

Program read_program_text(const std::string& path, std::string text, const ReadOptions& options, Diagnostics& said) {
    Parser parser(options, said);
    Program program = read_program(parser, path, std::move(text));
    parser.say_tallies();
    return program;
}

std::optional<std::string> read_scene_file(const std::string& path, const ReadOptions& options, Diagnostics& said) {
    std::optional<std::string> text = read_whole(path, options.limits.file_bytes);
    if (text) return text;
    SourcePos at;
    at.file = said.add_file(path);
    said.error(at, "the file cannot be read, or is too large");
    return std::nullopt;
}

Program read_program(const std::string& path, const ReadOptions& options, Diagnostics& said) {
    std::optional<std::string> text = read_scene_file(path, options, said);
    return text ? read_program_text(path, std::move(*text), options, said) : Program{};
}

}  // namespace alidade::pov

// SPDX-License-Identifier: Apache-2.0
/// Tokens with directives obeyed and macros expanded: what expressions and blocks are read from.
#pragma once

#include "importers/pov/random.h"
#include "importers/pov/settings.h"
#include "importers/pov/symbols.h"
#include "importers/pov/text_files.h"
#include "importers/pov/token_stream.h"

#include <exception>
#include <map>
#include <set>
#include <memory>

namespace alidade::pov {

/// What the bytes of string literals above 127 are: blanks, UTF-8, or an error, since POV-Ray 3.7 knows no character set of the system.
enum class Charset { ascii, utf8, system };

/// An error that ends the statement which is being read; Program reading goes on behind it.
struct Failure {
    Diagnostic diagnostic;
    bool fatal = false;          ///< a limit or #error: reading ends
    bool follows = false;        ///< from an error that is said already
    bool unmodelled = false;     ///< POV-Ray takes it
};

class Parser {
  public:
    Parser(const ReadOptions& options, Diagnostics& said);
    ~Parser();

    // ---- tokens ----
    /// Directives before it have been obeyed; never a macro's name. Of kind `end` at the end of the scene.
    Token next() {
        if (!has_ahead_) return fetch();
        has_ahead_ = false;
        return ahead_;
    }
    const Token& peek() {
        if (!has_ahead_) put_back(fetch());
        return ahead_;
    }
    /// Takes what peek() has shown.
    void take() { has_ahead_ = false; }
    void put_back(const Token& token) { ahead_ = token, has_ahead_ = true; }
    /// Takes the mark if it comes next.
    bool accept(char mark) {
        if (!peek().is(mark)) return false;
        has_ahead_ = false;
        return true;
    }
    /// What is not obeyed yet when the next token is looked for; with declarations and directives, macros are not called either.
    enum class Waiting { nothing, declarations, directives };
    /// What comes next, for a value that may go on: a #declare or #local ends it and is not obeyed yet (kind `directive`), and so does a macro, which may use
    /// what is being declared (kind `name`).
    Token peek_in_value() { return peek_within(Waiting::declarations); }
    /// The same where what stands there is a whole value to be declared: any directive may use it, and waits.
    Token peek_behind_value() { return peek_within(Waiting::directives); }
    Token expect(char mark, const char* where);
    /// The name behind #declare, #ifdef ...: not expanded if it is a macro.
    Token raw_token();
    std::string describe(const Token& token) const;
    const std::string& text(const Token& token) const { return stream.text(token); }
    Value vector(const Token& token) const;
    /// What a string literal is in the scene's character set.
    Value string(const Token& token);

    // ---- messages ----
    [[noreturn]] void fail(Place at, std::string message, std::string hint = {}) const;
    [[noreturn]] void fail_unmodelled(Place at, std::string message, std::string hint = {}) const;
    [[noreturn]] void fail_limit(Place at, std::string message, std::string hint = {}) const;
    /// The same of one that can be raised.
    [[noreturn]] void fail_limit(Place at, uint64_t Limits::*limit, std::string message) const { fail_limit(at, std::move(message), how_to_raise(options.limits, limit)); }
    /// Said once for each place.
    void warn(Place at, std::string message, std::string hint = {});
    /// An error that was caught. Said once: a loop comes to its place again and again.
    void report(Diagnostic error);
    /// A message with its line, and the includes and macro calls that lead to it.
    Diagnostic diagnostic(Severity severity, Place at, std::string message, std::string hint) const;
    /// Counted by `message`, and said once with the count when reading has ended.
    void tally(Place at, const std::string& message);
    void say_tallies();
    /// What the scene prints with #debug, #warning ...
    void print(TextStream stream, Place at, const std::string& text);

    // ---- files ----
    void open_scene(const std::string& path, std::string text);
    void include(const std::string& name, Place at);

    /// Work that was done at once counts as so many tokens: reading ends where there was too much of it.
    void charge(uint64_t steps, Place at);
    /// There is room for so many array elements more, or reading ends.
    void check_array_elements(uint64_t elements, Place at) const;
    void check_items(Place at) const;
    /// Guards the call stack of whoever walks values: builders, and what takes them apart.
    void check_depth(const Value& value, Place at) const;
    /// Taken back when an error has left it half way.
    void reset_nesting() { nesting_ = 0, has_ahead_ = false; }

    const ReadOptions& options;
    Diagnostics& said;
    Names names;
    TokenStream stream;
    Symbols symbols;
    RandomStreams random;
    TextFiles files;
    SourceFinder finder;
    double version = 3.7;             ///< as #version has set it; what POV-Ray starts with
    bool version_given = false;
    bool gamma_given = false;         ///< assumed_gamma stood before
    BlockStanding standing() const { return {uint32_t(defaults.size()), float(version), version_given, gamma_given}; }
    bool is_old() const { return !version_given || version < 3.7 - 1e-9; }
    /// Without assumed_gamma an old scene's numbers are what its files hold: no correction at all. But not where version 3.7 is told from outside (`+MV3.7`).
    bool lacks_gamma() const { return is_old() && !(options.version && *options.version >= 3.7 - 1e-9); }
    Charset charset = Charset::ascii;  ///< as global_settings has said
    bool keep_names = false;          ///< in function{}: names that nobody declared are parameters
    uint64_t loop_turns = 0;
    Ref<Meter> elements{new Meter}, items{new Meter};   ///< of all arrays, of all blocks
    std::vector<OpenItem> open_items;                     ///< of the blocks that are being read, those of the innermost last
    std::vector<std::pair<Place, Value>> defaults;    ///< #default, in order
    std::vector<Value> globals;                       ///< blocks of global_settings so far, in order
    std::set<WordId> failed_names;                    ///< whose declarations had errors: that they are not declared follows
    std::map<WordId, std::string> undeclared_hints;   ///< of names that were not declared: a loop comes to one again and again
    std::unique_ptr<class ObjectQueries> objects;     ///< made when an object is first asked for something
    std::unique_ptr<class SpaceFunctions> functions;  ///< made when the function of a pattern or a pigment is first called

  private:
    friend class Nested;
    void warn_of_nuls(uint16_t source);
    /// What a token names, if that is a macro.
    Macro* macro_of(const Token& token) const;
    Token fetch() {
        const Token& token = stream.raw();
        return token.is_plain() ? token : resolve(token, Waiting::nothing);
    }
    /// What is given out for `token`, which has been taken from the stream: directives are obeyed, macros are called.
    Token resolve(Token token, Waiting waiting);
    Token peek_within(Waiting waiting);
    Token end_of_frame();
    [[noreturn]] void fail_no_directive(const Token& hashed) const;
    void finish_frame();
    std::string path_of_include(const std::string& name, Place at);
    /// The tokens of a file of the disk, or of what the scene has written to a file in memory.
    uint16_t lexed(const std::string& path, const std::string* kept, Place at);
    void check_budget(Place at) const;

    uint64_t charged_ = 0;
    Token ahead_;
    bool has_ahead_ = false;     ///< peek() or put_back() has left a token
    size_t nesting_ = 0;
    std::vector<std::pair<uint64_t, std::string>> warned_;
    struct Tally {
        std::string message;
        Place first;
        size_t count;
    };
    std::vector<Tally> tallies_;
    std::unordered_map<std::string, uint16_t> lexed_;   ///< by path: an include that is read again is not lexed again, unless the scene has changed it
};

/// Guards the call stack: stands in every function that can call itself through what a scene nests.
class Nested {
  public:
    Nested(Parser& parser, Place at) : parser_(parser) {
        if (++parser_.nesting_ > parser_.options.limits.nesting)
            parser_.fail_limit(at, &Limits::nesting, fmt::format("brackets, blocks or calls are nested too deeply: more than {} in one another", parser_.options.limits.nesting));
    }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    ~Nested() { if (parser_.nesting_) --parser_.nesting_; }

  private:
    Parser& parser_;
};

}  // namespace alidade::pov

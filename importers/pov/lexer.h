// SPDX-License-Identifier: Apache-2.0
/// Text -> tokens, once a file: macros and loops replay them.
#pragma once

#include "importers/pov/source.h"
#include "importers/pov/words.h"

#include <deque>
#include <map>
#include <span>

namespace alidade::pov {

/// Those up to `mark` are given out as they are; the others have to be looked at first.
/// `hashed`: a name behind a #, which is nothing if the name is known.
enum class TokenKind : uint8_t { number, vector, string, word, mark, name, hashed, directive, bad, end };

/// Two-character operators as single ones.
inline constexpr char kLessEqual = 'l', kGreaterEqual = 'g', kNotEqual = 'n';

/// What the lexer knows of a directive.
struct DirectiveLink {
    uint16_t word;        ///< its reserved word
    uint16_t unmatched;   ///< a clause or #end without its opening directive
    uint32_t next;        ///< opening directives and clauses: the next clause or #end of the same structure; #end: its opening directive
};

/// 16 bytes, because a file of a million triangles has 26 million of them.
struct Token {
    TokenKind kind = TokenKind::end;
    char mark = 0;                ///< of a mark: the character itself, or one of the above; of no other
    uint16_t source = 0;
    uint32_t offset = 0;
    union {
        double number;
        uint32_t id;              ///< word, name, hashed: its number; string, bad: index into TokenList::texts; vector: into its vectors
        DirectiveLink directive;
    };

    Token() : number(0) {}
    bool is(char c) const { return mark == c; }
    bool is_plain() const { return kind <= TokenKind::mark; }
    bool is_word(WordId w) const { return kind == TokenKind::word && id == w; }
    Place place() const { return {source, offset}; }
};
static_assert(sizeof(Token) == 16);

/// No `next`: the structure is not closed in this file.
inline constexpr uint32_t kOpen = ~uint32_t(0);

struct TokenList {
    std::span<const Token> tokens;      ///< in a TokenRoom; ends with one of kind `end`
    std::vector<std::string> texts;     ///< string literals with their escapes resolved; what is wrong with bad tokens
    std::map<uint32_t, std::string> blanked;   ///< of the strings that have bytes above 127: the same with a blank for each of them
    std::vector<double> vectors;        ///< literals `<1, -2, 3>` of 2 to 5 numbers and nothing else: how many, and the numbers; most of a mesh's file
};

/// Where tokens live: they never move, and files stand one behind the other.
class TokenRoom {
  public:
    /// A list that holds `tokens` more without growing: there are as many as a file can have at the most, since growing would hold large lists twice.
    std::vector<Token>& with_space(size_t tokens);

  private:
    std::deque<std::vector<Token>> parts_;
};

/// The number of data files, whose tokens no parser sees: there `<` stands by itself.
inline constexpr uint16_t kDataSource = 0xffff;

/// What is wrong with the text (an open comment or string, a byte that means nothing) becomes a token `bad`: it is an error only if it is reached.
/// More than `max_tokens`, with the numbers in vectors: the list ends with a bad token.
TokenList lex(const Source& source, uint16_t number, Names& names, size_t max_tokens, TokenRoom& room);

}  // namespace alidade::pov

// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/lexer.h"

#include "importers/pov/utf8.h"

#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace alidade::pov {

namespace {

constexpr size_t kLongestName = 200;
constexpr size_t kUsualTokens = 1 << 18;   // of a part: the standard includes together have fewer bytes. What is not written to takes no memory

constexpr double kPowersOfTen[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

enum CharKind : uint8_t { kOther, kMark, kBlank, kDigit, kLetter };

constexpr std::array<CharKind, 256> char_kinds() {
    std::array<CharKind, 256> all{};
    for (const char mark : std::string_view("{}()[]<>,;:.=+-*/?&|!@^%")) all[size_t(mark)] = kMark;
    for (int c = 0; c < 256; ++c) {
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_') all[size_t(c)] = kLetter;
        if (c >= '0' && c <= '9') all[size_t(c)] = kDigit;
        if (c == ' ' || (c >= '\t' && c <= '\r') || c == 0x1a) all[size_t(c)] = kBlank;
    }
    return all;
}
constexpr std::array<CharKind, 256> kKinds = char_kinds();

CharKind kind_of(char c) { return kKinds[static_cast<unsigned char>(c)]; }
bool is_letter(char c) { return kind_of(c) == kLetter; }
bool is_digit(char c) { return kind_of(c) == kDigit; }

class Lexer {
  public:
    Lexer(const Source& source, uint16_t number, Names& names, std::vector<Token>& room)
        : text_(source.text()), number_(number), names_(names), tokens_(room), first_(room.size()) {}

    TokenList run(size_t max_tokens) {
        if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) bad(0, "the file is UTF-16: save it as UTF-8");
        while (number_ == 0 && at_ < text_.size() && static_cast<unsigned char>(text_[at_]) >= 0x80) ++at_;   // POV-Ray passes any such, as the byte order mark, where a scene begins
        const bool marked = at_ > 0;
        while (skip_blanks() && at_ < text_.size()) {
            if (count() + list_.vectors.size() >= max_tokens) {
                bad(at_, fmt::format("the file has more than {} tokens: --limit tokens=N allows more", max_tokens));
                break;
            }
            lex_one();
        }
        if (number_ == 0 && count() == 0 && (marked || text_.find('\0') != text_.npos)) bad(0, "the file is no text: nothing in it is a word, a number or a mark");
        start(TokenKind::end, text_.size());
        list_.tokens = {tokens_.data() + first_, count()};
        return std::move(list_);
    }

  private:
    size_t count() const { return tokens_.size() - first_; }

    /// A NUL stands behind the last byte of a source.
    char peek() const { return text_.data()[at_]; }
    char peek(size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    Token& start(TokenKind kind, size_t offset) {
        Token token;
        token.kind = kind, token.source = number_, token.offset = uint32_t(offset);
        return tokens_.emplace_back(token);
    }
    void with_text(TokenKind kind, size_t offset, std::string text) {
        start(kind, offset).id = uint32_t(list_.texts.size());
        list_.texts.push_back(std::move(text));
    }
    void bad(size_t offset, std::string message) { with_text(TokenKind::bad, offset, std::move(message)); }

    /// Blanks, NULs among them, and comments; block comments nest. False if one is not closed.
    bool skip_blanks() {
        for (; at_ < text_.size(); ++at_) {
            skip_plain_blanks();
            if (peek() == '\0' && at_ < text_.size()) continue;
            if (peek() != '/') return true;
            if (peek(1) == '/') {
                at_ = std::min(end_of_line(at_), text_.size() - 1);
            } else if (peek(1) == '*') {
                if (!skip_comment()) return false;
            } else {
                return true;
            }
        }
        return true;
    }

    /// Where a line feed stands behind `from`, or a carriage return by itself as in files of old Macintoshes.
    size_t end_of_line(size_t from) {
        const auto seek = [&](char c, size_t& next) {
            if (next <= from) next = std::min(text_.find(c, from), text_.size());       // sought once: a large file may have none
        };
        seek('\n', next_feed_), seek('\r', next_return_);
        return std::min(next_feed_, next_return_);
    }

    bool skip_comment() {
        const size_t opened = at_;
        int depth = 0;
        size_t taken = at_;   // what is before it belongs to a mark already
        for (size_t slash = at_; (slash = text_.find('/', slash)) != text_.npos; ++slash) {   // one stands in both marks
            if (slash > taken && text_[slash - 1] == '*') {
                taken = slash + 1;
                if (--depth == 0) return at_ = slash, true;
            } else if (slash + 1 < text_.size() && text_[slash + 1] == '*') {
                ++depth, taken = slash + 2;
            }
        }
        at_ = text_.size();
        bad(opened, "the comment is not closed");
        return false;
    }

    void lex_one() {
        const char c = peek();
        if (at_number()) return lex_number();
        if (is_letter(c)) return lex_name();
        if (c == '"') return lex_string();
        if (c == '#') return lex_directive();
        lex_mark();
    }

    void lex_number() {
        const size_t begin = at_;
        const double value = take_number();
        if (peek() == '.') return bad(at_++, "the number has a second point");
        start(TokenKind::number, begin).number = value;
    }

    /// Up to 15 digits and a power of ten up to 10^15 are exact as doubles, so that one division rounds as reading all at once would.
    double take_number() {
        constexpr size_t kExactDigits = 15;
        const size_t begin = at_;
        uint64_t digits = 0;
        const auto take_digits = [&] {
            const size_t first = at_;
            for (; is_digit(peek()); ++at_) digits = digits * 10 + uint64_t(peek() - '0');     // wraps, and is not used, where there are too many
            return at_ - first;
        };
        const size_t before = take_digits();
        const size_t behind = peek() == '.' ? ++at_, take_digits() : 0;
        if (peek() != 'e' && peek() != 'E' && before + behind <= kExactDigits) return double(digits) / kPowersOfTen[behind];
        return take_long_number(begin);
    }

    /// As in POV-Ray, an exponent without digits is 0.
    double take_long_number(size_t begin) {
        if (peek() == 'e' || peek() == 'E')
            for (at_ += peek(1) == '+' || peek(1) == '-' ? 2 : 1; is_digit(peek());) ++at_;
        double value = 0;
        const auto [_, failed] = std::from_chars(text_.data() + begin, text_.data() + at_, value);
        if (failed == std::errc::result_out_of_range) value = std::strtod(std::string(text_.substr(begin, at_ - begin)).c_str(), nullptr);
        return value;
    }
    bool at_number() const { return is_digit(peek()) || (peek() == '.' && is_digit(peek(1))); }

    /// Behind a `<`: the rest of a literal `<1, -2, 3>` that is nothing but numbers and commas, as one token. Or nothing is taken.
    bool take_vector(size_t begin) {
        const size_t before = at_;
        std::array<double, 6> numbers{};              // how many, and up to five
        for (size_t count = 1; count <= 5; ++count) {
            skip_plain_blanks();
            const char sign = peek();
            if (sign == '-' || sign == '+') ++at_;
            if (!at_number()) break;
            numbers[count] = sign == '-' ? -take_number() : take_number();
            skip_plain_blanks();
            const char behind = peek();
            ++at_;
            if (behind == ',') continue;
            if (behind != '>' || count < 2 || peek() == '=') break;
            start(TokenKind::vector, begin).id = uint32_t(list_.vectors.size());
            numbers[0] = double(count);
            list_.vectors.insert(list_.vectors.end(), numbers.begin(), numbers.begin() + std::ptrdiff_t(count) + 1);
            return true;
        }
        at_ = before;
        return false;
    }
    void skip_plain_blanks() {
        const char* at = text_.data() + at_;
        while (kind_of(*at) == kBlank) ++at;
        at_ = size_t(at - text_.data());
    }

    /// The number of the name that begins here, or nothing if it is too long.
    std::optional<WordId> take_name() {
        const char* const begin = text_.data() + at_;
        const char* end = begin;
        NameHash hash;
        for (; kind_of(*end) >= kDigit; ++end) hash.add(*end);
        at_ += size_t(end - begin);
        if (size_t(end - begin) > kLongestName) return std::nullopt;
        return names_.id({begin, size_t(end - begin)}, hash.value());
    }

    void lex_name() {
        const size_t begin = at_;
        const std::optional<WordId> id = take_name();
        if (!id) return bad(begin, fmt::format("a name has more than {} characters", kLongestName));
        start(*id < kWordCount ? TokenKind::word : TokenKind::name, begin).id = *id;
    }

    void lex_string() {
        const size_t opened = at_++;
        std::string value, blanked;
        for (; peek() != '"'; ++at_) {
            const size_t before = value.size();
            if (at_ >= text_.size()) return bad(opened, "the string is not closed");
            if (peek() == '\r' || peek() == '\n') {
                value += take_line_end();
            } else if (peek() != '\\') {
                value += peek();
            } else if (++at_; !escape(value)) {
                return bad(at_ - 1, "this escape sequence is not known in a string");
            }
            if (value.size() == before + 1 && static_cast<unsigned char>(value.back()) >= 0x80) blanked += ' ';
            else blanked.append(value, before);
        }
        ++at_;
        for (std::string* text : {&value, &blanked}) text->resize(std::min(text->find('\0'), text->size()));       // which ends it in POV-Ray
        if (value != blanked) list_.blanked.emplace(uint32_t(list_.texts.size()), std::move(blanked));
        with_text(TokenKind::string, opened, std::move(value));
    }

    /// Every convention's end of a line is one line feed; at_ stands on its last byte.
    char take_line_end() {
        if (peek(1) != peek() && (peek(1) == '\r' || peek(1) == '\n')) ++at_;
        return '\n';
    }

    /// The character after a backslash.
    bool escape(std::string& value) {
        static constexpr std::string_view kFrom = "abfnrtv\\'\"", kTo = "\a\b\f\n\r\t\v\\'\"";
        if (const size_t known = kFrom.find(peek()); known != std::string_view::npos && at_ < text_.size()) {
            value += kTo[known];
            return true;
        }
        uint32_t code = 0;
        const std::string_view digits = peek() == 'u' ? text_.substr(at_ + 1, 4) : std::string_view();
        const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (digits.size() < 4 || failed != std::errc() || end != digits.data() + 4) return false;
        append_utf8(value, code);
        at_ += 4;
        return true;
    }

    /// Blanks may stand behind #. One means nothing, and is no error, if there is no word behind it, or one of those that are no directives (some programs write `#global_settings`).
    void lex_directive() {
        const size_t begin = at_++;
        if (!skip_blanks() || !is_letter(peek())) return;
        const size_t name = at_;
        const std::optional<WordId> id = take_name();
        if (!id) return bad(begin, fmt::format("there is no directive #{}", text_.substr(name, kLongestName)));
        if (*id >= kWordCount) return void(start(TokenKind::hashed, begin).id = *id);
        if (!is_directive(*id)) return void(start(TokenKind::word, name).id = *id);
        Token& token = start(TokenKind::directive, begin);
        token.directive = {uint16_t(*id), 0, kOpen};
        match(token, uint32_t(count() - 1));
    }

    /// What a character that belongs to nothing is, for those that editors put in unasked.
    std::string meaningless(size_t begin) const {
        const auto byte = static_cast<unsigned char>(text_[begin]);
        if (byte > 32 && byte < 127) return fmt::format("the character {} means nothing here", text_[begin]);
        const std::string text(text_.substr(begin, 4));
        const uint32_t code = characters(text)[0];
        if (byte < 0x80 || code == byte || code == 0xFEFF) return fmt::format("the byte 0x{:02X} means nothing here", byte);
        const char* meant = code == 0xA0 || (code >= 0x2000 && code <= 0x200B) ? ": it looks like a blank, write one" : code >= 0x2018 && code <= 0x201F ? ": strings stand in \" \"" : (code >= 0x2010 && code <= 0x2015) || code == 0x2212 ? ": a minus sign is -" : "";
        return fmt::format("the character U+{:04X} means nothing here{}", code, meant);
    }

    void lex_mark() {
        const size_t begin = at_++;
        char mark = text_[begin];
        if (mark == '<' && number_ != kDataSource && take_vector(begin)) return;
        if (kind_of(mark) != kMark) return bad(begin, meaningless(begin));
        if (peek() == '=' && (mark == '<' || mark == '>' || mark == '!')) {
            mark = mark == '<' ? kLessEqual : mark == '>' ? kGreaterEqual : kNotEqual;
            ++at_;
        }
        start(TokenKind::mark, begin).mark = mark;
    }

    /// Links every #if, #while ... to its clauses and its #end, so that what is not taken is jumped over.
    void match(Token& token, uint32_t index) {
        switch (token.directive.word) {
            case "if"_w: case "ifdef"_w: case "ifndef"_w: case "while"_w: case "for"_w: case "switch"_w: case "macro"_w:
                opened_.push_back({index, index});
                break;
            case "else"_w: case "elseif"_w: case "case"_w: case "range"_w: case "end"_w: {
                token.directive.unmatched = opened_.empty();
                if (opened_.empty()) break;
                tokens_[first_ + opened_.back().last].directive.next = index;
                opened_.back().last = index;
                if (token.directive.word != "end"_w) break;
                token.directive.next = opened_.back().first;
                opened_.pop_back();
                break;
            }
            default: break;
        }
    }

    /// An open structure: its directive, and the last of its clauses.
    struct Structure {
        uint32_t first, last;
    };

    std::string_view text_;
    uint16_t number_;
    Names& names_;
    std::vector<Token>& tokens_;      ///< of this file from first_ on; has room for all
    size_t first_;
    std::vector<Structure> opened_;
    size_t at_ = 0;
    size_t next_feed_ = 0, next_return_ = 0;
    TokenList list_;
};

}  // namespace

TokenList lex(const Source& source, uint16_t number, Names& names, size_t max_tokens, TokenRoom& room) {
    return Lexer(source, number, names, room.with_space(std::min(source.text().size(), max_tokens) + 2)).run(max_tokens);
}

std::vector<Token>& TokenRoom::with_space(size_t tokens) {
    if (parts_.empty() || parts_.back().capacity() - parts_.back().size() < tokens) parts_.emplace_back().reserve(std::max(tokens, kUsualTokens));
    return parts_.back();
}

}  // namespace alidade::pov

// SPDX-License-Identifier: Apache-2.0
/// #fopen, #fclose, #read, #write (POV-Ray reference, 3.3.2.3). Reading works where includes may lie; writing in the folder that the options name, and nowhere else.
#include "importers/pov/directives.h"
#include "importers/pov/expressions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

Ref<TextFile> open_for_writing(Parser& p, const std::string& name, bool append, Place at) {
    Ref<TextFile> file(new TextFile);
    file->path = name, file->writing = true;
    if (p.options.write_folder) {
        const std::optional<std::string> path = TextFiles::below(*p.options.write_folder, name);
        if (!path) p.fail(at, fmt::format("the file {} lies outside of the folder that may be written to", name));
        file->path = *path;
        if (!p.files.open_on_disk(file, append)) p.fail(at, fmt::format("the file {} cannot be written", file->path));
        return file;
    }
    p.tally(at, fmt::format("the file {} is not written, since --allow-write DIR has not allowed it: the scene alone can read it", name));
    const auto found = append && !p.files.kept(name) ? p.finder.find(name) : std::nullopt;
    p.files.open_in_memory(*file);
    if (found) *file->kept = read_whole(found->path, p.options.limits.file_bytes).value_or("");
    if (!append) file->kept->clear();
    return file;
}

Ref<TextFile> open_for_reading(Parser& p, const std::string& name, Place at) {
    p.files.flush();
    const std::string* kept = p.files.kept(name);
    const std::optional<SourceFinder::Found> found = kept ? std::nullopt : p.finder.find(name);
    std::optional<std::string> text = kept ? std::optional(*kept) : found ? read_whole(found->path, p.options.limits.file_bytes) : std::nullopt;
    if (!text && p.options.write_folder)                          // what the scene itself has written
        if (const std::optional<std::string> path = TextFiles::below(*p.options.write_folder, name)) text = read_whole(*path, p.options.limits.file_bytes);
    if (!text) p.fail(at, fmt::format("the file {} is not found", name));
    Ref<TextFile> file(new TextFile);
    file->path = found ? found->path : name;
    file->source.emplace(file->path, std::move(*text), 0);
    file->list = lex(*file->source, kDataSource, p.names, p.options.limits.tokens_in_file, file->room);
    return file;
}

void open(Parser& p) {
    const Token name = p.raw_token();
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("a name is expected behind #fopen, not {}", p.describe(name)));
    const Place at = p.peek().place();
    const std::string path = parse_string(p);
    const Token how = p.next();
    Ref<TextFile> file;
    if (how.is_word("read"_w)) file = open_for_reading(p, path, at);
    else if (how.is_word("write"_w) || how.is_word("append"_w)) file = open_for_writing(p, path, how.is_word("append"_w), at);
    else p.fail(how.place(), fmt::format("read, write or append is expected, not {}", p.describe(how)));
    p.symbols.global(name.id).value = Value::of(Kind::file, file);
}

TextFile& file_of(Parser& p, const Token& name) {
    Slot* slot = name.kind == TokenKind::name ? p.symbols.find(name.id) : nullptr;
    if (!slot || slot->value.kind != Kind::file) p.fail(name.place(), fmt::format("the name of an open file is expected, not {}", p.describe(name)));
    return slot->value.as<TextFile>();
}

void close_file(Parser& p) {
    const Token name = p.raw_token();
    if (name.kind == TokenKind::name && !p.symbols.find(name.id)) return;      // read to its end, and so closed already
    TextFile& file = file_of(p, name);
    if (file.writing && !file.kept) file.out.close();
    if (!file.out) p.fail(name.place(), fmt::format("the file {} cannot be written", file.path));
    p.symbols.undefine(name.id);
}

/// What stands next in a data file; of kind `end` behind all.
const Token& peek(const TextFile& file) { return file.list.tokens[file.at]; }
bool ended(const TextFile& file) { return peek(file).kind == TokenKind::end; }
void skip(TextFile& file) { file.at += !ended(file); }

/// `expected` is what the data file should have where it stands now.
[[noreturn]] void fail_in_data(Parser& p, Place at, const TextFile& file, std::string_view expected) {
    const Token& token = peek(file);
    const SourcePos where = file.source->position(token.offset);
    p.fail(at, fmt::format("{} line {}, column {}: {}", file.path, where.line, where.column,
                           token.kind == TokenKind::bad ? file.list.texts[token.id] : fmt::format("{} is expected here, not {}", expected, ended(file) ? "the end of the file" : "this")));
}

/// A number with a sign or without: no expressions stand in data files.
double read_number(Parser& p, Place at, TextFile& file) {
    const bool minus = peek(file).is('-');
    if (minus || peek(file).is('+')) skip(file);
    if (peek(file).kind != TokenKind::number) fail_in_data(p, at, file, "a number");
    const double x = peek(file).number;
    skip(file);
    return minus ? -x : x;
}

/// Of numbers and commas between them, which may be missing.
Value read_vector(Parser& p, Place at, TextFile& file) {
    constexpr int kMostComponents = 5;
    Value v = Value::vector(0, {});
    for (skip(file); v.terms == 0 || !peek(file).is('>');) {
        if (v.terms == kMostComponents) fail_in_data(p, at, file, "the > of the vector");
        v.c[v.terms++] = read_number(p, at, file);
        if (peek(file).is(',')) skip(file);
    }
    if (v.terms < 2) fail_in_data(p, at, file, "a second component");
    return skip(file), v;
}

/// A number, a vector <...> or a string "...", as #write leaves them. POV-Ray takes one more token behind each, be it a comma or not.
Value read_value(Parser& p, Place at, TextFile& file) {
    const Token& first = peek(file);
    if (first.kind == TokenKind::string) return skip(file), Value::string(file.list.texts[first.id]);
    if (first.is('<')) return read_vector(p, at, file);
    return Value::number(read_number(p, at, file));
}

/// `#read(FILE, names)`. Names for which nothing is left keep their values; the first of them for which a value was still looked for is defined() even if it has none. With the last value the file is closed; behind a comma, which promises
/// another, only with the next #read, so that a loop makes one more turn with what it had (probed).
void read(Parser& p) {
    p.expect('(', "behind #read");
    const Token name = p.raw_token();
    const Ref<TextFile> file(&file_of(p, name));
    if (file->writing) p.fail(name.place(), fmt::format("the file {} is open for writing", file->path));
    bool at_end = ended(*file), over = false;
    while (p.accept(',')) {
        const Token into = p.raw_token();
        if (into.kind != TokenKind::name) p.fail(into.place(), fmt::format("a name is expected, not {}", p.describe(into)));
        const bool known_array = p.symbols.find(into.id) && p.symbols.find(into.id)->value.kind == Kind::array;
        if (ended(*file)) {
            if (!over && !p.symbols.find(into.id)) p.symbols.declare(into.id);   // without a value
            at_end = over = true;
            continue;
        }
        const Ref<Slot> slot = known_array ? parse_reference(p, into, true) : Ref<Slot>(&p.symbols.declare(into.id));
        slot->value = read_value(p, into.place(), *file);
        if (peek(*file).kind == TokenKind::bad) fail_in_data(p, into.place(), *file, "");
        at_end = over = ended(*file);
        if (!peek(*file).is(',') && !at_end) p.warn(into.place(), fmt::format("{} line {}: a comma is missing, and what stands there is lost in its place, as in POV-Ray", file->path, file->source->position(peek(*file).offset).line));
        skip(*file);
    }
    p.expect(')', "behind the names of #read");
    if (at_end) p.symbols.undefine(name.id);
}

/// Floats as "%g"; vectors as "<%g,%g,%g> ", with a blank behind.
std::string written(const Value& value) {
    if (value.kind == Kind::string) return value.text();
    if (value.kind == Kind::number) return fmt::format("{:g}", value.c[0]);
    std::string all = fmt::format("<{:g}", value.c[0]);
    for (int i = 1; i < value.terms; ++i) all += fmt::format(",{:g}", value.c[i]);
    return all + "> ";
}

void write(Parser& p) {
    p.expect('(', "behind #write");
    const Token name = p.raw_token();
    const Ref<TextFile> file(&file_of(p, name));
    if (!file->writing) p.fail(name.place(), fmt::format("the file {} is open for reading", file->path));
    while (!p.accept(')')) {
        p.accept(',');                           // POV-Ray takes values without commas, too
        const Place at = p.peek().place();
        const Value value = parse_expression(p);
        if (!value.numeric() && value.kind != Kind::string) p.fail(at, fmt::format("{} cannot be written", kind_name(value)));
        const std::string text = written(value);
        p.files.written += text.size();
        if (p.files.written > p.options.limits.written_bytes) p.fail_limit(at, &Limits::written_bytes, fmt::format("the scene writes more than {} bytes", p.options.limits.written_bytes));
        if (!TextFiles::write(*file, text)) p.fail(at, fmt::format("the file {} cannot be written", file->path));
    }
}

}  // namespace

void obey_file_directive(Parser& p, const Token& directive) {
    switch (directive.directive.word) {
        case "fopen"_w: return open(p);
        case "fclose"_w: return close_file(p);
        case "read"_w: return read(p);
        default: return write(p);
    }
}

}  // namespace alidade::pov

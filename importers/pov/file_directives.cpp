// SPDX-License-Identifier: Apache-2.0
/// #fopen, #fclose, #read, #write (POV-Ray reference, 3.3.2.3). Reading works where includes may lie; writing in the folder that the options name, and nowhere else.
#include "importers/pov/directives.h"
#include "importers/pov/expressions.h"

#include <charconv>
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
    file->path = found ? found->path : name, file->text = std::move(*text);
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

void close(Parser& p) {
    const Token name = p.raw_token();
    if (name.kind == TokenKind::name && !p.symbols.find(name.id)) return;      // read to its end, and so closed already
    TextFile& file = file_of(p, name);
    if (file.writing && !file.kept) file.out.close();
    if (!file.out) p.fail(name.place(), fmt::format("the file {} cannot be written", file.path));
    p.symbols.undefine(name.id);
}

bool ended(const TextFile& file) { return file.at >= file.text.size(); }

/// Behind the comment that stands here, if one does: as in a scene, though not nested.
bool skip_comment(TextFile& file) {
    const std::string_view rest = std::string_view(file.text).substr(file.at);
    const std::string_view end = rest.substr(0, 2) == "//" ? "\n" : rest.substr(0, 2) == "/*" ? "*/" : "";
    if (end.empty()) return false;
    const size_t found = rest.find(end, 2);
    file.at = found == std::string_view::npos ? file.text.size() : file.at + found + end.size();
    return true;
}

/// Blanks, commas and comments. Was there a comma?
bool skip_separators(TextFile& file) {
    bool comma = false;
    while (!ended(file)) {
        const char here = file.text[file.at];
        if (std::string_view(" \t\r\n,").find(here) != std::string_view::npos) ++file.at, comma |= here == ',';
        else if (!skip_comment(file)) break;
    }
    return comma;
}

std::optional<double> read_number(TextFile& file) {
    skip_separators(file);
    if (file.at < file.text.size() && file.text[file.at] == '+') ++file.at;
    double x = 0;
    const char *begin = file.text.data() + file.at, *end = file.text.data() + file.text.size();
    const auto [behind, failed] = std::from_chars(begin, end, x);
    if (behind == begin || failed != std::errc()) return std::nullopt;
    file.at = size_t(behind - file.text.data());
    return x;
}

/// A float, a vector <...> or a string "...", as #write leaves them.
std::optional<Value> read_value(TextFile& file) {
    skip_separators(file);
    if (ended(file)) return std::nullopt;
    if (file.text[file.at] == '"') {
        const size_t end = file.text.find('"', file.at + 1);
        if (end == std::string::npos) return std::nullopt;
        Value text = Value::string(file.text.substr(file.at + 1, end - file.at - 1));
        file.at = end + 1;
        return text;
    }
    if (file.text[file.at] != '<') {
        const std::optional<double> x = read_number(file);
        return x ? std::optional(Value::number(*x)) : std::nullopt;
    }
    Value v = Value::vector(0, {});
    ++file.at;
    while (v.terms < 5) {
        const std::optional<double> x = read_number(file);
        if (!x) break;
        v.c[v.terms++] = *x;
    }
    skip_separators(file);
    if (v.terms < 2 || file.at >= file.text.size() || file.text[file.at] != '>') return std::nullopt;
    ++file.at;
    return v;
}

/// `#read(FILE, names)`. Names for which nothing is left keep their values. With the last value the file is closed; behind a comma, which promises
/// another, only with the next #read, so that a loop makes one more turn with what it had (probed).
void read(Parser& p) {
    p.expect('(', "behind #read");
    const Token name = p.raw_token();
    const Ref<TextFile> file(&file_of(p, name));
    if (file->writing) p.fail(name.place(), fmt::format("the file {} is open for writing", file->path));
    bool promised = true;
    while (p.accept(',')) {
        const Token into = p.raw_token();
        if (into.kind != TokenKind::name) p.fail(into.place(), fmt::format("a name is expected, not {}", p.describe(into)));
        const bool known_array = p.symbols.find(into.id) && p.symbols.find(into.id)->value.kind == Kind::array;
        if (skip_separators(*file); ended(*file)) {
            promised = false;
            continue;
        }
        const Ref<Slot> slot = known_array ? parse_reference(p, into, true) : Ref<Slot>(&p.symbols.declare(into.id));
        std::optional<Value> value = read_value(*file);
        if (!value) p.fail(into.place(), fmt::format("the file {} has no further number, vector or string here (byte {})", file->path, file->at));
        slot->value = std::move(*value);
        promised = skip_separators(*file);
    }
    p.expect(')', "behind the names of #read");
    if (ended(*file) && !promised) p.symbols.undefine(name.id);
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
        if (p.files.written > p.options.limits.written_bytes) p.fail_limit(at, fmt::format("the scene writes more than {} bytes", p.options.limits.written_bytes));
        if (!TextFiles::write(*file, text)) p.fail(at, fmt::format("the file {} cannot be written", file->path));
    }
}

}  // namespace

void obey_file_directive(Parser& p, const Token& directive) {
    switch (directive.directive.word) {
        case "fopen"_w: return open(p);
        case "fclose"_w: return close(p);
        case "read"_w: return read(p);
        default: return write(p);
    }
}

}  // namespace alidade::pov

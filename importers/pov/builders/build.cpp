// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/build.h"

#include "importers/pov/builders/misplaced.h"
#include "importers/pov/builders/transforms.h"
#include "importers/pov/expressions.h"
#include "importers/pov/operators.h"

#include <fmt/format.h>

namespace alidade::pov {

SourcePos Build::position(Place at) const {
    if (at.source >= p.stream.sources()) return {};
    return p.stream.source(uint16_t(at.source)).position(at.offset);
}

NodeId Build::add_node(Node&& node) {
    constexpr size_t kMostNodes = 1'500'000;
    if (scene.nodes.size() >= kMostNodes) p.fail_limit({}, fmt::format("the scene has more than {} objects", kMostNodes));
    append(scene.nodes, std::move(node));
    return {uint32_t(scene.nodes.size() - 1)};
}

SignalId Build::add_signal(Signal signal) {
    append(scene.signals, std::move(signal));
    return {uint32_t(scene.signals.size() - 1)};
}

SignalId Build::add_signal(decltype(Signal::what) what, Place at) {
    Signal signal;
    signal.what = std::move(what);
    signal.from = position(at);
    return add_signal(std::move(signal));
}

bool Cursor::accept(WordId word) {
    if (!at_word(word)) return false;
    ++i_;
    return true;
}

const Block* Cursor::any_block() const {
    return !done() && peek().value_kind() == Kind::block && peek().kind != Item::Kind::entry ? &peek().block() : nullptr;
}

const Block* Cursor::block_at(WordId word) const {
    const Block* block = any_block();
    return block && block->word == word ? block : nullptr;
}

double Cursor::number(const char* what) {
    if (!at_number()) build_.p.fail(place(), fmt::format("a number is expected as {}", what));
    return next().number();
}

int Cursor::integer(const char* what, int low, int high) {
    const double x = number(what);
    return x >= low ? x <= high ? int(x) : high : low;
}

Vec3 Cursor::vector(const char* what, uint8_t terms) {
    if (!at_numeric()) build_.p.fail(place(), fmt::format("a vector is expected as {}", what));
    const Item& item = next();
    const std::array<double, 5> c = wanted_vector(build_.p, item.value(), terms, item.place, "as", what);
    return {c[0], c[1], c[2]};
}

std::array<double, 5> Cursor::colour(const char* what) {
    if (!at_numeric()) build_.p.fail(place(), fmt::format("a colour is expected as {}", what));
    return promoted(next().value(), 5);        // a float by itself is all five
}

Color Cursor::rgb(const char* what) {
    if (done() || peek().kind != Item::Kind::value) return build_.p.warn(place(), fmt::format("no colour is given as {}: it is black, as in POV-Ray", what)), Color(0);
    const std::array<double, 5> c = colour(what);
    return {c[0], c[1], c[2]};
}

bool Cursor::flag() {
    if (!at_number()) return true;
    return truth(next().number());
}

bool Cursor::at_transform() const { return !done() && begins_transform(peek()); }

Transform Cursor::transform() { return take_transform(build_.p, block_, i_); }

void Cursor::skip() {
    const bool takes_values = peek().kind == Item::Kind::word;
    ++i_;
    if (takes_values) skip_values();
}

void Cursor::skip_quick_colour() {
    build_.p.tally(place(), fmt::format("a colour in {} is ignored, as in POV-Ray: colours belong in a pigment", kWords[block_.word]));
    skip();
}

void Cursor::skip_values() {
    while (!done() && (peek().kind == Item::Kind::numbers || (peek().kind == Item::Kind::value && !any_block()))) ++i_;
}

void Cursor::refuse_misplaced() const {
    const Block* block = any_block();
    if (!block && peek().kind != Item::Kind::word) return;
    const WordId word = block ? block->word : peek().word;
    if (block && (belongs_to_objects(word) || (at_declared() && belongs_to_objects(block_.word))))
        build_.p.fail(peek().place, fmt::format("{}{} {} cannot stand in {}", at_declared() ? "the identifier of a" : "a", kWords[word][0] == 'i' ? "n" : "", kWords[word], kWords[block_.word]));
    if (const auto home = belongs_elsewhere(word, block_.word)) build_.p.fail(peek().place, fmt::format("{} cannot stand in {}", kWords[word], kWords[block_.word]), fmt::format("it is a word of {}", *home));
}

void Cursor::skip_unmodelled() {
    const Item& item = peek();
    const Block* block = any_block();
    const bool named = item.kind == Item::Kind::word || block;
    const std::string_view word = named ? kWords[block ? block->word : item.word] : std::string_view("a value");
    refuse_misplaced();
    if (!named) build_.p.fail(item.place, fmt::format("a value means nothing here in {}", kWords[block_.word]));
    else if (!block && belongs_to_objects(item.word)) build_.p.fail(item.place, fmt::format("{{ is expected behind {}", word));
    else build_.p.tally(item.place, fmt::format("{} in {} is not modelled yet: it is left out", word, kWords[block_.word]));
    skip();
}

void Cursor::skip_unmodelled_pattern() {
    if (at_function()) skip();                       // what it calls was told
    else skip_unmodelled();
    skip_values();
}

}  // namespace alidade::pov

// SPDX-License-Identifier: Apache-2.0
/// What all builders share: the scene that is being built, and a walk over the items of a block.
#pragma once

#include "importers/pov/fonts.h"
#include "importers/pov/parser.h"
#include "scene/scene.h"

#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace alidade::pov {

/// A node that stands for an object.
struct BuiltObject {
    NodeId node;
    bool limits = true;      ///< may it clip or bound others? POV-Ray refuses textures, lights and triangles, also in its parts
};

/// Appends. Where there is no room any more, what is there is moved: std::vector would copy it, since GLM does not promise that copying its vectors cannot throw.
template <class T>
void append(std::vector<T>& all, T&& one) {
    if (all.size() == all.capacity()) {
        std::vector<T> more;
        more.reserve(2 * all.size() + 16);
        std::move(all.begin(), all.end(), std::back_inserter(more));
        all.swap(more);
    }
    all.push_back(std::move(one));
}

/// The scene under construction. Builders read blocks and add to it; what they do not model they tally with the parser.
struct Build {
    explicit Build(Parser& parser) : p(parser) {}

    Parser& p;
    Scene scene;
    std::vector<Value> defaults;                        ///< blocks of #default, in order
    std::map<const Block*, BuiltObject> declared;       ///< objects that were referred to, so that each is stored once
    std::map<std::string, std::shared_ptr<Font>> fonts; ///< by the name in the scene
    std::map<std::pair<const Font*, uint32_t>, std::optional<Glyph>> glyphs;
    std::map<std::tuple<const Font*, uint32_t, uint64_t>, ShapeId> letters;   ///< glyphs as shapes, by the bits of their depth: stored once for all texts
    std::map<std::string, ImageId> images;              ///< by path
    bool gamma_given = false;                           ///< assumed_gamma stood in the scene
    std::vector<PovFinish> default_textures;            ///< what holds after each of them; the first: before all
    std::map<uint32_t, MaterialId> default_materials;   ///< by the number of #default before

    std::map<std::pair<const Block*, SignalId>, SignalId> pigments;                                 ///< what a block made of a pigment
    std::map<std::pair<const Block*, std::optional<SignalId>>, SignalId> normals;    ///< of a normal
    std::map<SignalId, PatternSignal> loose_modifiers;   ///< of plain colours: transformations, turbulence ..., which act on a pattern that a later block puts in their place
    std::map<SignalId, PatternSignal> around_uv;         ///< of pigments that say uv_mapping: POV-Ray has them as a pattern of one pigment, its map here, and what follows changes that pattern alone
    std::map<SignalId, ReliefSignal> around_uv_normals;  ///< the same of normals
    std::map<SignalId, ConstantSignal> quick_colors;     ///< of pigments that have one
    std::set<SignalId> without_maps;                     ///< pigments that have their pattern's own colours: those of another pattern that takes its place are its own again
    std::map<const Block*, MaterialId> parts;           ///< textures of maps
    std::map<const Function*, FunctionId> functions;     ///< what was made of functions,
    std::map<const Function*, ImageId> function_pictures;   ///< of those of pictures,
    std::vector<uint32_t> function_calls;               ///< how many calls stand in one another in each of the scene's,
    std::map<const Block*, SignalId> number_patterns;   ///< and of the patterns that they ask
    int function_levels = 0;                            ///< of brackets and calls around what is being made of one
    int number_of_waves = 10;                           ///< of waves and ripples

    bool shapes_alone = false;                          ///< textures, materials and interiors are passed over: the scene is asked where its shapes are, and not drawn
    int copying = 0;                                    ///< references that are being built anew because their texture changes
    int lit_globally = 0;                               ///< light groups around what is built that take global lights
    int by_name = 0;                                    ///< names that what is built was reached by: POV-Ray copies what is declared
    size_t copies_of_copies = 0;                        ///< those among them that stood in another: each level can double them

    SourcePos position(Place at) const;
    /// Fails where a scene copies its parts into parts of parts without end.
    NodeId add_node(Node&& node);
    SignalId add_signal(Signal signal);
    SignalId add_signal(decltype(Signal::what) what, Place at);
};

/// Reads the items of a block one after the other. All `take` functions fail, with the place, where something else stands.
class Cursor {
  public:
    /// Begins behind the first `skipped` items.
    Cursor(Build& build, const Block& block, size_t skipped = 0) : build_(build), block_(block), i_(skipped) {}

    bool done() const { return i_ >= block_.items().size(); }
    const Item& peek() const { return block_.items()[i_]; }
    /// Is it an identifier that holds the block, and not the block itself?
    bool at_declared() const { return peek().kind == Item::Kind::value; }
    const Item& next() { return block_.items()[i_++]; }
    Place place() const { return done() ? block_.place : peek().place; }
    const Block& block() const { return block_; }

    bool at_word(WordId word) const { return !done() && peek().kind == Item::Kind::word && peek().word == word; }
    bool at_block(WordId word) const { return block_at(word) != nullptr; }
    bool at_number() const { return !done() && peek().kind == Item::Kind::value && peek().value_kind() == Kind::number; }
    bool at_colour() const { return !done() && peek().kind == Item::Kind::value && peek().value_kind() == Kind::colour; }
    bool at_function() const { return !done() && peek().kind == Item::Kind::value && peek().value_kind() == Kind::function; }
    bool at_numeric() const { return !done() && peek().kind == Item::Kind::value && peek().numeric(); }
    /// Takes the word if it comes next.
    bool accept(WordId word);
    /// `word { ... }`, or an identifier that stands for one, if it comes next: not taken.
    const Block* block_at(WordId word) const;
    /// What a block item or an identifier of an object holds, or null.
    const Block* any_block() const;

    double number(const char* what);
    /// A number cut to `low` .. `high`.
    int integer(const char* what, int low, int high);
    /// Shorter ones are filled with zeros, and a float stands for all; longer ones and colours are refused.
    Vec3 vector(const char* what, uint8_t terms = 3);
    /// red, green, blue, filter, transmit; a float stands for equal red, green and blue.
    std::array<double, 5> colour(const char* what);
    Color rgb(const char* what);
    /// The value of a switch: `on`, `off` ... or, if none stands there, true.
    bool flag();
    bool at_transform() const;
    Transform transform();
    /// Fails if the word that comes next is one that POV-Ray does not take in such a block.
    void refuse_misplaced() const;
    /// Skips what comes next, a word with its values, and tallies it as not modelled.
    /// Fails as `refuse_misplaced`.
    void skip_unmodelled();
    /// The same of a pattern, with the values behind it; it may be a function of what is not modelled, which has been told.
    void skip_unmodelled_pattern();
    /// Skips a colour beside an object or a declared light, which POV-Ray takes from old scenes and ignores, as it says.
    void skip_quick_colour();
    /// Skips it without a word: it has no influence on a picture.
    void skip();

  private:
    void skip_values();

    Build& build_;
    const Block& block_;
    size_t i_;
};

}  // namespace alidade::pov

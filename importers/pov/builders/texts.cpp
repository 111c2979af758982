// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/texts.h"

#include "eval/shapes/shape_ops.h"

#include "importers/pov/fonts.h"
#include "importers/pov/rotation.h"
#include "importers/pov/utf8.h"

#include <bit>
#include <filesystem>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

namespace fs = std::filesystem;

/// POV-Ray's own, in the order of `internal 1` to `internal 4`.
constexpr const char* kOwnFonts[] = {"timrom.ttf", "cyrvetic.ttf", "crystal.ttf", "povlogo.ttf"};

constexpr const char* kSystemFonts[] = {"/usr/share/fonts", "/usr/local/share/fonts"};

/// Scenes name fonts by paths of other machines: the last part is what counts.
std::optional<std::string> in_system_folders(const std::string& path) {
    const fs::path name = fs::path(path).filename();
    if (name.empty()) return std::nullopt;
    for (const char* folder : kSystemFonts) {
        std::error_code failed;
        for (fs::recursive_directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
            if (it->path().filename() == name) return it->path().string();
    }
    return std::nullopt;
}

bool is_own_font(const std::string& name) {
    return std::find(std::begin(kOwnFonts), std::end(kOwnFonts), name) != std::end(kOwnFonts);
}

/// Where the scene's files are, then where the system has its fonts; without an ending it means ".ttf".
std::optional<std::string> find_font(const Build& build, const std::string& name) {
    for (const std::string& tried : {name, name + ".ttf"}) {
        if (const auto found = build.p.finder.find(tried)) return found->path;
        if (const auto found = in_system_folders(tried)) return found;
    }
    return std::nullopt;
}

const Font& font_named(Build& build, const std::string& name, Place place) {
    const auto known = build.fonts.find(name);
    if (known != build.fonts.end()) return *known->second;
    constexpr uint64_t kMostBytes = 64 << 20;
    const auto path = find_font(build, name);
    if (!path) {
        const bool own = is_own_font(name) || is_own_font(name + ".ttf");
        build.p.fail(place, fmt::format("the font \"{}\" is not found", name), own ? "it is one of POV-Ray's own: install the package fonts-povray" : "fonts are looked for where includes are, then in /usr/share/fonts");
    }
    auto bytes = read_whole(*path, kMostBytes);
    auto font = bytes ? Font::read(std::move(*bytes)) : std::nullopt;
    if (!font) build.p.fail(place, fmt::format("{} is not a TrueType font", *path));
    return *build.fonts.emplace(name, std::make_shared<Font>(std::move(*font))).first->second;
}

std::string take_string(Build& build, Cursor& at, const char* what) {
    if (at.done() || at.peek().kind != Item::Kind::value || at.peek().value_kind() != Kind::string) build.p.fail(at.place(), fmt::format("a string is expected as {}", what));
    return at.next().text();
}

/// `ttf "name"` or `internal 1`.
const Font& take_font(Build& build, Cursor& at) {
    const Place place = at.place();
    if (at.accept("internal"_w)) return font_named(build, kOwnFonts[at.integer("the number of an internal font", 1, int(std::size(kOwnFonts))) - 1], place);
    if (!at.accept("ttf"_w)) build.p.fail(place, "ttf or internal is expected in text { }");
    const Place name = at.place();
    return font_named(build, take_string(build, at, "the name of a font"), name);
}

/// POV-Ray turns all letters by a thousandth of a degree about each axis through where the text begins (by experiment, with trace()): in the front of a glass
/// letter that stands upright, texture and highlight show it.
const Transform& turn_of_letters() {
    static const Transform turn{rotation(Vec3(0.001)), Vec3(0)};
    return turn;
}

/// The letters of a text. Those of one scene that look the same are stored once.
class Letters {
  public:
    Letters(Build& build, const Font& font, double depth, SourcePos from) : build_(build), font_(font), depth_(depth), from_(std::move(from)) {}

    /// Null if the font has no outlines for it that can be used.
    const Glyph* glyph(uint32_t index) {
        auto known = build_.glyphs.find({&font_, index});
        if (known == build_.glyphs.end()) known = build_.glyphs.emplace(std::pair(&font_, index), font_.glyph(index)).first;
        return known->second ? &*known->second : nullptr;
    }

    NodeId node(uint32_t index, const Vec2& place) {
        const std::tuple key(&font_, index, std::bit_cast<uint64_t>(depth_));
        auto known = build_.letters.find(key);
        if (known == build_.letters.end()) known = build_.letters.emplace(key, add_shape(*glyph(index))).first;
        Node node;
        node.what = known->second;
        node.to_parent = turn_of_letters() * Transform::translate(Vec3(place.x, place.y, 0));
        node.from = from_;
        return build_.add_node(std::move(node));
    }

    /// Of a letter that has been placed.
    Bounds box(uint32_t index) const {
        const ShapeGeometry& letter = build_.scene.shapes[build_.letters.at({&font_, index, std::bit_cast<uint64_t>(depth_)}).index].geometry;
        return find_shape(letter)->bounds(letter);
    }

  private:
    ShapeId add_shape(const Glyph& glyph) {
        ShapeEntry entry;
        entry.geometry = Extrusion{glyph.outlines, 0, depth_, false};
        entry.from = from_;
        append(build_.scene.shapes, std::move(entry));
        return {uint32_t(build_.scene.shapes.size() - 1)};
    }

    Build& build_;
    const Font& font_;
    double depth_;
    SourcePos from_;
};

}  // namespace

BuiltText build_text(Build& build, Cursor& at) {
    const Place place = at.place();
    const Font& font = take_font(build, at);
    const std::vector<uint32_t> text = characters(take_string(build, at, "the letters of a text"));
    const double depth = at.number("the depth of a text");
    const Vec3 offset = at.vector("the offset of a text's letters");
    const bool ascii = build.p.charset != Charset::utf8;
    Letters letters(build, font, depth, build.position(place));
    BuiltText out;
    double along = 0, left = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        const uint32_t index = font.glyph_of(text[i], ascii);
        const Glyph* glyph = letters.glyph(index);
        if (!glyph) {
            build.p.tally(place, "a letter whose outlines are not those of a TrueType font is left out");
            continue;
        }
        if (i == 0) left = glyph->left;
        const Vec3 pen(along - left + double(i) * offset.x, double(i) * offset.y, 0);
        Bounds own{Vec3(0, 0, std::min(depth, 0.0)), Vec3(0, 0, std::max(depth, 0.0))};
        if (!glyph->outlines.empty()) {
            out.letters.push_back(letters.node(index, Vec2(pen.x, pen.y)));
            own = letters.box(index), own.max.x -= std::min(own.min.x - glyph->moved, 0.0);
            own.min.x = glyph->left;
        }
        out.box.extend(turn_of_letters().bounds(Bounds{own.min + pen, own.max + pen}));
        along += glyph->advance;
        if (i + 1 < text.size()) along += font.kerning(index, font.glyph_of(text[i + 1], ascii));
    }
    return out;
}

}  // namespace alidade::pov

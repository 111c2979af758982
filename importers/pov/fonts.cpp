// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace alidade::pov {

struct Font::Face {
    std::string bytes;            ///< FreeType reads them as long as the face lives
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    FT_CharMap by_unicode = nullptr, by_ascii = nullptr;

    Face() = default;
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }
    double em() const { return face->units_per_EM; }
};

namespace {

struct Mapping {
    FT_UShort platform, encoding;
};
constexpr Mapping kMicrosoft{3, 1}, kSymbols{3, 0}, kUnicode{0, 3}, kMacintosh{1, 0};

/// The first of them that the font has; without any, FreeType's choice.
FT_CharMap first_of(FT_Face face, std::initializer_list<Mapping> wanted) {
    for (const Mapping& mapping : wanted)
        for (int i = 0; i < face->num_charmaps; ++i)
            if (face->charmaps[i]->platform_id == mapping.platform && face->charmaps[i]->encoding_id == mapping.encoding) return face->charmaps[i];
    return face->charmap;
}

/// Collects what FT_Outline_Decompose says. Coordinates come doubled, so that the points that TrueType leaves out, halfway between two control points,
/// are exact.
struct Collector {
    double scale;
    std::vector<Outline> outlines;
    bool quadratic = true;

    Vec2 point(const FT_Vector* v) const { return {double(v->x) * scale, double(v->y) * scale}; }
    std::vector<Vec2>& points() { return outlines.back().points; }

    static int move(const FT_Vector* to, void* self) {
        Collector& c = *static_cast<Collector*>(self);
        c.outlines.push_back({{c.point(to)}});
        return 0;
    }
    static int line(const FT_Vector* to, void* self) {
        Collector& c = *static_cast<Collector*>(self);
        const Vec2 from = c.points().back(), end = c.point(to);
        if (end != from) c.points().push_back(from), c.points().push_back(end);
        return 0;
    }
    static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
        Collector& c = *static_cast<Collector*>(self);
        c.points().push_back(c.point(control));
        c.points().push_back(c.point(to));
        return 0;
    }
    static int cubic(const FT_Vector*, const FT_Vector*, const FT_Vector*, void* self) {
        static_cast<Collector*>(self)->quadratic = false;
        return 1;
    }

    /// The last point is the first one again, or a line leads back to it.
    void close() {
        for (Outline& outline : outlines) {
            std::vector<Vec2>& p = outline.points;
            if (p.size() > 1 && p.back() == p.front()) p.pop_back();
            else p.push_back(p.back());
        }
        std::erase_if(outlines, [](const Outline& outline) { return outline.points.size() < 4; });
    }
};

/// In font units: the left side bearing of a glyph that is composed of others, that of the component whose metrics it says it has; nothing if it is a simple one. Loads other glyphs.
std::optional<FT_Pos> bearing_of_composite(FT_Face face, uint32_t index) {
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_RECURSE) != 0 || face->glyph->format != FT_GLYPH_FORMAT_COMPOSITE) return std::nullopt;
    uint32_t measured = index;
    for (FT_UInt i = 0; i < face->glyph->num_subglyphs; ++i) {
        FT_Int component, along, up;
        FT_UInt flags;
        FT_Matrix matrix;
        if (FT_Get_SubGlyph_Info(face->glyph, i, &component, &flags, &along, &up, &matrix) == 0 && (flags & FT_SUBGLYPH_FLAG_USE_MY_METRICS)) measured = uint32_t(component);
    }
    if (FT_Load_Glyph(face, measured, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) return std::nullopt;
    return face->glyph->metrics.horiBearingX;
}

}  // namespace

Font::Font(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Font::Font(Font&&) noexcept = default;
Font::~Font() = default;

std::optional<Font> Font::read(std::string bytes) {
    auto face = std::make_unique<Face>();
    face->bytes = std::move(bytes);
    if (FT_Init_FreeType(&face->library) != 0) return std::nullopt;
    if (FT_New_Memory_Face(face->library, reinterpret_cast<const FT_Byte*>(face->bytes.data()), FT_Long(face->bytes.size()), 0, &face->face) != 0) return std::nullopt;
    if (!FT_IS_SCALABLE(face->face) || face->face->units_per_EM == 0) return std::nullopt;
    face->by_unicode = first_of(face->face, {kMicrosoft, kSymbols, kUnicode, kMacintosh});
    face->by_ascii = first_of(face->face, {kMacintosh, kUnicode, kMicrosoft, kSymbols});
    return Font(std::move(face));
}

uint32_t Font::glyph_of(uint32_t character, bool ascii) const {
    constexpr uint32_t kSymbolPage = 0xf000;
    FT_Set_Charmap(face_->face, ascii ? face_->by_ascii : face_->by_unicode);
    const uint32_t index = FT_Get_Char_Index(face_->face, character);
    return index == 0 && character < 256 ? FT_Get_Char_Index(face_->face, kSymbolPage + character) : index;
}

std::optional<Glyph> Font::glyph(uint32_t index) const {
    const FT_Face face = face_->face;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return std::nullopt;
    FT_Outline_Funcs functions{};
    functions.move_to = Collector::move, functions.line_to = Collector::line, functions.conic_to = Collector::conic, functions.cubic_to = Collector::cubic;
    functions.shift = 1;
    Collector collector{0.5 / face_->em(), {}};
    if (FT_Outline_Decompose(&face->glyph->outline, &functions, &collector) != 0 || !collector.quadratic) return std::nullopt;
    collector.close();
    Glyph out;
    out.outlines = std::move(collector.outlines);
    out.advance = double(face->glyph->metrics.horiAdvance) / face_->em(), out.left = double(face->glyph->metrics.horiBearingX) / face_->em();
    const auto bearing = bearing_of_composite(face, index);
    if (!bearing) return out;
    out.left = out.moved = double(*bearing) / face_->em();
    for (Outline& outline : out.outlines)
        for (Vec2& p : outline.points) p.x += out.moved;
    return out;
}

double Font::kerning(uint32_t left, uint32_t right) const {
    FT_Vector added{};
    if (FT_Get_Kerning(face_->face, left, right, FT_KERNING_UNSCALED, &added) != 0) return 0;
    return double(added.x) / face_->em();
}

}  // namespace alidade::pov

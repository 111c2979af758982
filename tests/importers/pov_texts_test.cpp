// SPDX-License-Identifier: Apache-2.0
/// Letters beyond ASCII, against where POV-Ray 3.7 has them.
#include "eval/shapes/shape_ops.h"
#include "tests/importers/pov_builders.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

double right_end(const Scene& s) {
    double most = 0;
    for (const Node& node : s.nodes) {
        const auto* shape = std::get_if<ShapeId>(&node.what);
        if (!shape) continue;
        const ShapeGeometry& geometry = s.shapes[shape->index].geometry;
        most = std::max(most, node.to_parent.bounds(find_shape(geometry)->bounds(geometry)).max.x);
    }
    return most;
}

/// The right ends are those of POV-Ray's max_extent().
TEST_F(PovBuilders, LettersWithAccentsStandWherePovRayHasThem) {
    const std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (!std::filesystem::exists(font)) GTEST_SKIP() << "fonts-dejavu-core is not installed";
    for (const auto& [letters, right] : {std::pair("\u00e9", 0.5620), {"\u00ed", 0.3042}, {"\u00edx", 0.7427}, {"x\u00e9x", 1.6890}, {"\u00c9", 0.5679}, {"o", 0.5020}}) {
        EXPECT_NEAR(right_end(scene("global_settings { charset utf8 } text { ttf \"" + font + "\" \"" + letters + "\" .2, 0 }")), right, 1e-4) << letters;
    }
    // min_extent(), as the centre of a sphere: that box begins where the text does.
    for (const char* letters : {"\u00e9", "\u00ee", "\u00ec", "o"}) {
        const Scene s = scene("global_settings { charset utf8 } #declare T = text { ttf \"" + font + "\" \"" + letters + "\" .2, 0 } sphere { min_extent(T), 1 }");
        ASSERT_EQ(s.shapes.size(), 1u);
        EXPECT_NEAR(std::get<Sphere>(s.shapes[0].geometry).center.x, 0, 1e-4) << letters;
    }
}

/// Of fonts whose numbers for the Macintosh are not Unicode: 142 is its e with an acute accent, 233 its E with a grave one. What is in no map is the font's box. Right ends as above.
TEST_F(PovBuilders, WithoutCharsetUtf8LettersAreThoseOfTheMacintosh) {
    const std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (!std::filesystem::exists(font)) GTEST_SKIP() << "fonts-dejavu-core is not installed";
    const auto right = [&](const char* settings, const std::string& letters) { return right_end(scene(std::string(settings) + "text { ttf \"" + font + "\" " + letters + " .2, 0 }")); };
    for (const char* settings : {"", "global_settings { charset ascii } "}) {
        EXPECT_NEAR(right(settings, "chr(142)"), 0.56203, 1e-4);
        EXPECT_NEAR(right(settings, "chr(233)"), 0.56789, 1e-4);
        EXPECT_NEAR(right(settings, "chr(300)"), 0.50002, 1e-4);
        EXPECT_NEAR(right(settings, "\"a\\u00e9b\""), 1.76467, 1e-4);
        EXPECT_NEAR(right(settings, "\"a\u00e9b\""), 1.7686, 1e-4) << "two bytes, two blanks";
    }
    EXPECT_NEAR(right("global_settings { charset utf8 } ", "chr(233)"), 0.56203, 1e-4);
    EXPECT_NEAR(right("global_settings { charset utf8 } ", "\"a\u00e9b\""), 1.74806, 1e-4);
    EXPECT_THAT(said("text { ttf \"timrom.ttf\" \"\u00e9\" 1, 0 }"), HasSubstr("s.pov:1:25: warning: what is not ASCII in a string is blanks"));
}

}  // namespace
}  // namespace alidade

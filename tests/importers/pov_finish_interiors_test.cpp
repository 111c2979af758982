// SPDX-License-Identifier: Apache-2.0
/// What finishes of POV-Ray 3.0 say of interiors, against what POV-Ray 3.7 draws: the numbers were measured behind tilted panes of glass.
#include "tests/importers/pov_builders.h"

#include <fmt/ranges.h>

namespace alidade {
namespace {

using PovFinishInteriors = PovBuilders;

/// ior / refraction of all shapes, in order; a single far one, of radius 9, is left out.
void collect_interiors(const Scene& s, NodeId id, std::optional<InteriorId> inside, std::vector<std::string>& out) {
    const Node& node = s.nodes[id.index];
    if (node.interior) inside = node.interior;
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) {
        const auto* sphere = std::get_if<Sphere>(&s.shapes[shape->index].geometry);
        const Interior in = inside ? s.interiors[inside->index] : Interior();
        if (sphere && sphere->radius != 9) out.push_back(fmt::format("{}/{}", in.ior, in.refraction));
    }
    for (const NodeId child : node.children) collect_interiors(s, child, inside, out);
}

std::string interiors_of(const Scene& s) {
    std::vector<std::string> out;
    for (const NodeId root : s.roots) collect_interiors(s, root, {}, out);
    return fmt::format("{}", fmt::join(out, " "));
}

/// In the scenes: A and B say both, C an ior alone, N nothing; I is an interior; _ has no texture.
std::string with_names(const std::string& scene) {
    std::string out = "#declare A = texture { finish { ior 1.2 refraction .9 } } #declare B = texture { finish { ior 1.5 refraction .8 } } #declare C = texture { finish { ior 1.4 } } #declare N = texture { finish { diffuse 0 } }\n"
                      "#declare M = texture { gradient x texture_map { [0 B] [1 B] } }\n";
    for (const char c : scene)
        switch (c) {
            case 'A': case 'B': case 'C': case 'N': case 'M': out += fmt::format(" sphere {{ 0, 1 texture {{ {} }} }}", c); break;
            case 'I': out += " sphere { 0, 1 interior { ior 1.8 } texture { N } }"; break;
            case 'J': out += " sphere { 0, 1 interior { ior 1.8 } texture { A } }"; break;
            case '_': out += " sphere { 0, 1 }"; break;
            case 'f': out += " sphere { 90, 9 }"; break;
            case 'u': out += " union {"; break;
            case 'd': out += " difference {"; break;
            case 'a': case 'b': out += fmt::format(" texture {{ {} }}", c == 'a' ? "A" : "B"); break;
            case 'm': out += " texture { M }"; break;
            case 'i': out += " interior { ior 2 }"; break;
            case '!': out += " cutaway_textures"; break;
            default: out += c;
        }
    return out;
}

TEST_F(PovFinishInteriors, ThePartsOfASetShareOneAndTheLastFinishWins) {
    const std::pair<const char*, const char*> cases[] = {
        {"A", "1.2/0.9"}, {"AB", "1.2/0.9 1.5/0.8"}, {"uAB}", "1.5/0.8 1.5/0.8"}, {"uBA}", "1.2/0.9 1.2/0.9"}, {"uAC}", "1.4/1 1.4/1"}, {"uAN}", "1.2/1 1.2/1"}, {"uNA}", "1.2/0.9 1.2/0.9"},
        {"uAf}", "1.2/1"}, {"dAf}", "1.2/1"}, {"dAf!}", "1.2/0.9"}, {"uuAB}N}", "1.5/1 1.5/1 1.5/1"}, {"uBuNA}}", "1.2/0.9 1.2/0.9 1.2/0.9"},
        {"uA_b}", "1.5/0.8 1.5/0.8"}, {"u_Ab}", "1.2/0.9 1.2/0.9"}, {"uNNb}", "1.5/1 1.5/1"}, {"uAuNN}b}", "1.5/1 1.5/1 1.5/1"}, {"uuNNb}A}", "1.2/0.9 1.2/0.9 1.2/0.9"},
        {"uAI}", "1.2/0.9 1.8/1"}, {"uIA}", "1.8/1 1.2/0.9"}, {"uJB}", "1.2/0.9 1.5/0.8"}, {"J", "1.2/0.9"}, {"uABi}", "1.5/0.8 1.5/0.8"}, {"uuABi}N}", "1.5/0.8 1.5/0.8 1/1"}, {"uNuANi}i}", "2/1 1.2/1 1.2/1"},
        {"M", "1/1"}, {"uAM}", "1.2/0.9 1.2/0.9"}, {"uA_m}", "1.2/0.9 1.2/0.9"},
    };
    for (const auto& [names, expected] : cases) EXPECT_EQ(interiors_of(scene("#version 3.0;" + with_names(names))), expected) << names;
}

TEST_F(PovFinishInteriors, TheDefaultFinishIsThatOfPartsAndNotOfSets) {
    const std::string later = " #default { finish { ior 1.4 refraction .7 } } ";
    EXPECT_EQ(interiors_of(scene("#version 3.0; #declare N = texture { finish { diffuse 0 } }" + later + "union { sphere { 0, 1 texture { N } } sphere { 0, 1 texture { N } } }")), "1/1 1/1");
    EXPECT_EQ(interiors_of(scene("#version 3.0;" + later + "union { sphere { 0, 1 } sphere { 0, 1 } }")), "1.4/0.7 1.4/0.7");
}

TEST_F(PovFinishInteriors, OtherTexturesOfAnObjectSayNothing) {
    const std::string a = "#version 3.0; #declare A = texture { finish { ior 1.2 refraction .9 } } #declare B = texture { finish { ior 1.5 refraction .8 } } union { sphere { 0, 1 texture { A } }";
    EXPECT_EQ(interiors_of(scene(a + " mesh { triangle { 0, x, y texture { B } } } }")), "1.2/0.9") << "a mesh all of whose triangles have their own has none";
    EXPECT_EQ(interiors_of(scene(a + " mesh { triangle { 0, x, y texture { B } } triangle { 0, x, z } } }")), "1.2/1");
    EXPECT_EQ(interiors_of(scene(a + " mesh { triangle { 0, x, y } texture { B } } }")), "1.5/0.8");
    EXPECT_EQ(interiors_of(scene(a + " torus { 2, 1 texture { A } interior_texture { B } } }")), "1.2/0.9");
    EXPECT_EQ(interiors_of(scene("#version 3.0; sphere { 0, 1 texture { finish { ior 1.2 } } texture { pigment { rgbt 1 } finish { ior 1.5 } } }")), "1.5/1");
    EXPECT_EQ(interiors_of(scene("#version 3.0; sphere { 0, 1 texture { finish { ior 1.2 } } texture { pigment { rgbt 1 } } }")), "1/1");
}

TEST_F(PovFinishInteriors, ObjectsMadeOfOneDeclarationHaveTheirOwn) {
    const std::string o = "#version 3.0; #declare A = texture { finish { ior 1.2 refraction .9 } } #declare O = sphere { 0, 1 texture { A } } #declare U = union { object { O } sphere { 0, 1 texture { finish { ior 1.5 } } } } ";
    EXPECT_EQ(interiors_of(scene(o + "object { O } union { object { O } sphere { 0, 1 texture { finish { ior 1.7 } } } }")), "1.2/0.9 1.7/1 1.7/1");
    EXPECT_EQ(interiors_of(scene(o + "union { object { U } object { U } object { O } } U")), "1.2/0.9 1.2/0.9 1.2/0.9 1.2/0.9 1.2/0.9 1.5/1 1.5/1");
}

TEST_F(PovFinishInteriors, EqualOnesAreOne) {
    const std::string o = "#version 3.0; #declare O = union { sphere { 0, 1 texture { finish { ior 1.2 } } } sphere { x, 1 } } ";
    const size_t one = scene(o + "object { O }").interiors.size();
    EXPECT_EQ(scene(o + "#declare I = 0; #while (I < 50) object { O translate I*y } #declare I = I + 1; #end").interiors.size(), one);
}

TEST_F(PovFinishInteriors, AnIorBelowZeroIsNone) { EXPECT_EQ(interiors_of(scene("#version 3.0; sphere { 0, 1 interior { ior 1.8 } finish { ior -1 } }")), "1.8/1"); }

}  // namespace
}  // namespace alidade

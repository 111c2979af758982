// SPDX-License-Identifier: Apache-2.0
#include "core/diagnostics.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Diagnostics, TextOfALineWithCaretHintAndIncludes) {
    Diagnostics said;
    const uint32_t room = said.add_file("room.pov"), main = said.add_file("main.pov");
    Diagnostic d;
    d.at = {room, 2, 15, ""};
    d.message = "cylinder has no length: both ends are <0,0,0>";
    d.hint = "give it two different ends, or use a disc";
    d.excerpt = "cylinder { 0, 0, 1 }";
    d.called_from.push_back({{room, 9, 1, ""}, "Wall"});
    d.called_from.push_back({{main, 7, 1, ""}, ""});
    said.add(d);
    EXPECT_EQ(said.text(),
              "room.pov:2:15: error: cylinder has no length: both ends are <0,0,0>\n"
              "    cylinder { 0, 0, 1 }\n"
              "                  ^\n"
              "hint: give it two different ends, or use a disc\n"
              "    in macro Wall, called from room.pov:9:1\n"
              "    included from main.pov:7:1\n");
}

TEST(Diagnostics, PlacesAreAsPreciseAsTheyAreKnown) {
    Diagnostics said;
    const uint32_t file = said.add_file("a.gltf");
    EXPECT_EQ(said.where({}), "alidade");
    EXPECT_EQ(said.where({file, 0, 0, ""}), "a.gltf");
    EXPECT_EQ(said.where({file, 3, 0, ""}), "a.gltf:3");
    EXPECT_EQ(said.where({file, 0, 0, "/nodes/3/mesh"}), "a.gltf:/nodes/3/mesh");
    EXPECT_EQ(said.where({99, 3, 1, ""}), "alidade:3:1") << "a file that nobody added is not read";
}

TEST(Diagnostics, FilesAreKnownOnce) {
    Diagnostics said;
    EXPECT_EQ(said.add_file("a"), said.add_file("a"));
    EXPECT_NE(said.add_file("a"), said.add_file("b"));
    EXPECT_EQ(said.files().size(), 2u);
}

TEST(Diagnostics, KeepsTheFirstHundredOfAKindAndCountsTheRest) {
    Diagnostics said;
    for (int i = 0; i < 250; ++i) said.error({}, std::string("e").append(std::to_string(i)));
    for (int i = 0; i < 101; ++i) said.warning({}, "w");
    said.note({}, "n");
    EXPECT_TRUE(said.has_errors());
    EXPECT_EQ(said.errors(), 250u);
    EXPECT_EQ(said.warnings(), 101u);
    EXPECT_EQ(said.list().size(), 201u);
    const std::string text = said.text();
    EXPECT_NE(text.find("error: e99\n"), std::string::npos);
    EXPECT_EQ(text.find("error: e100\n"), std::string::npos);
    EXPECT_NE(text.find("alidade: note: n\n"), std::string::npos);
    EXPECT_NE(text.find("... and 150 more errors\n... and 1 more warnings\n"), std::string::npos);
}

TEST(Diagnostics, AppendMovesFilesAndCountsWhatWasLeftOut) {
    Diagnostics inner, outer;
    outer.add_file("x.obj");
    inner.error({inner.add_file("y.mtl"), 4, 2, ""}, "no such colour");
    inner.error({inner.add_file("x.obj"), 1, 0, ""}, "no such file");
    for (int i = 0; i < 120; ++i) inner.warning({}, "w");
    outer.append(inner);
    EXPECT_EQ(outer.errors(), 2u);
    EXPECT_EQ(outer.warnings(), 120u);
    EXPECT_EQ(outer.files().size(), 2u);
    EXPECT_EQ(outer.text(outer.list()[0]), "y.mtl:4:2: error: no such colour\n");
    EXPECT_EQ(outer.text(outer.list()[1]), "x.obj:1: error: no such file\n");
    EXPECT_FALSE(Diagnostics().has_errors());
}

}  // namespace
}  // namespace alidade

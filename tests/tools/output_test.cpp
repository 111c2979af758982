// SPDX-License-Identifier: Apache-2.0
#include "tools/output.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A folder of its own for each test, gone afterwards.
class Output : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "alidade_output_XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::string in(const char* name) const { return (folder / name).string(); }

    std::filesystem::path folder;
};

/// A film of 3x2 pixels with two layers; channel c of pixel (x, y) is (10 y + x) / 100 + c.
Picture film() {
    Picture picture(3, 2, {"R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z"});
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (int c = 0; c < 7; ++c) picture.at(x, y)[c] = float(10 * y + x) / 100 + float(c);
    return picture;
}

/// core/image.h, write_file: a device takes the bytes.
TEST_F(Output, TakesNoDevicesPlace) {
    EXPECT_EQ(why_no_file("/dev/null"), "") << "a device takes the bytes, and stays";
    EXPECT_EQ(why_no_file(in("new.csv")), "");
}

TEST_F(Output, AnExrHoldsAllLayers) {
    const auto files = write_film(in("a.exr"), film());
    ASSERT_TRUE(files) << files.error();
    EXPECT_THAT(*files, ElementsAre(in("a.exr")));
    const auto back = read_picture(in("a.exr"), Encoding::linear);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->channels, 7);
}

TEST_F(Output, OtherFormatsHaveTheirLayersBeside) {
    const auto files = write_film(in("a.b.png"), film());
    ASSERT_TRUE(files) << files.error();
    EXPECT_THAT(*files, ElementsAre(in("a.b.png"), in("a.b.depth.exr"), in("a.b.normal.exr")));
    const auto normal = read_picture(in("a.b.normal.exr"), Encoding::linear);
    ASSERT_TRUE(normal) << normal.error();
    EXPECT_THAT(normal->names, testing::UnorderedElementsAre("normal.X", "normal.Y", "normal.Z"));
    const auto z = size_t(std::find(normal->names.begin(), normal->names.end(), "normal.Z") - normal->names.begin());
    EXPECT_EQ(normal->at(2, 1)[z], film().at(2, 1)[6]);
}

TEST_F(Output, SaysBeforehandWhatCannotBeWritten) {
    EXPECT_EQ(why_not_writable(in("a.png")), "");
    EXPECT_EQ(why_not_writable("a.png"), "");
    EXPECT_THAT(why_not_writable(in("none/a.png")), HasSubstr("there is no folder"));
    EXPECT_THAT(why_not_writable(folder.string()), HasSubstr("is a folder"));
    EXPECT_THAT(why_not_writable(folder.string() + "/"), HasSubstr("is a folder"));
    EXPECT_THAT(why_not_writable(in("a")), HasSubstr("no ending"));
    EXPECT_THAT(why_not_writable(in("a.xyz")), HasSubstr("no picture format that can be written has the ending .xyz"));
    EXPECT_EQ(why_no_file(in("a.xyz")), "");
}

}  // namespace
}  // namespace alidade

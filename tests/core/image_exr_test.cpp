// SPDX-License-Identifier: Apache-2.0
/// EXR files as other programs write them: half and integer channels, tiles, several parts, windows that differ, every lossless compression.
#include "core/image_colors.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace alidade {
namespace {

using Imath::Box2i;
using Imath::V2i;

/// A value that half, float and integer hold exactly and that tells its place.
int value_at(int x, int y) { return 40 * (y + 20) + x + 20; }

struct Layout {
    Box2i data{V2i(0, 0), V2i(12, 8)}, display{V2i(0, 0), V2i(12, 8)};
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    Imf::PixelType type = Imf::HALF;
    bool tiled = false;
};

class ExrFiles : public testing::Test {
  protected:
    void SetUp() override { path_ = testing::TempDir() + "alidade-exr-" + std::to_string(getpid()) + ".exr"; }
    void TearDown() override { unlink(path_.c_str()); }

    Imf::Header header(const Layout& layout) {
        Imf::Header header(layout.display, layout.data);
        header.compression() = layout.compression;
        for (const char* name : {"Z", "B", "A", "G", "R"}) header.channels().insert(name, Imf::Channel(layout.type));
        return header;
    }

    /// R, G, B, A, Z hold 1 to 5 times value_at.
    Imf::FrameBuffer frame(const Layout& layout) {
        const int width = layout.data.max.x - layout.data.min.x + 1, height = layout.data.max.y - layout.data.min.y + 1;
        const size_t pixels = size_t(width) * size_t(height);
        Imf::FrameBuffer frame;
        const char* names[] = {"R", "G", "B", "A", "Z"};
        for (int c = 0; c < 5; ++c) {
            auto& half_values = halves_[c];
            auto& int_values = integers_[c];
            half_values.resize(pixels), int_values.resize(pixels);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const int value = (c + 1) * value_at(x + layout.data.min.x, y + layout.data.min.y);
                    half_values[size_t(y * width + x)] = float(value % 2048), int_values[size_t(y * width + x)] = unsigned(value % 2048);
                }
            void* base = layout.type == Imf::HALF ? static_cast<void*>(half_values.data()) : int_values.data();
            const size_t size = layout.type == Imf::HALF ? 2 : 4;
            frame.insert(names[c], Imf::Slice::Make(layout.type, base, layout.data, size, size * size_t(width)));
        }
        return frame;
    }

    void write(const Layout& layout) {
        Imf::Header head = header(layout);
        if (layout.tiled) {
            head.setTileDescription(Imf::TileDescription(4, 4));
            Imf::TiledOutputFile file(path_.c_str(), head, 0);
            file.setFrameBuffer(frame(layout));
            file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        } else {
            Imf::OutputFile file(path_.c_str(), head, 0);
            file.setFrameBuffer(frame(layout));
            file.writePixels(layout.data.max.y - layout.data.min.y + 1);
        }
    }

    void expect_pixels(const Layout& layout, const std::vector<std::string>& further = {}) {
        const auto picture = read_picture(path_, Encoding::automatic);
        ASSERT_TRUE(picture) << picture.error();
        std::vector<std::string> names{"R", "G", "B", "A", "Z"};
        names.insert(names.end(), further.begin(), further.end());
        ASSERT_EQ(picture->names, names);
        ASSERT_EQ(picture->width, layout.display.max.x - layout.display.min.x + 1);
        ASSERT_EQ(picture->height, layout.display.max.y - layout.display.min.y + 1);
        for (int y = layout.display.min.y; y <= layout.display.max.y; ++y)
            for (int x = layout.display.min.x; x <= layout.display.max.x; ++x)
                for (int c = 0; c < 5; ++c) {
                    const int want = layout.data.intersects(V2i(x, y)) ? (c + 1) * value_at(x, y) % 2048 : 0;
                    ASSERT_EQ(picture->at(x - layout.display.min.x, y - layout.display.min.y)[c], float(want)) << x << " " << y << " " << c;
                }
    }

    std::string path_;
    std::vector<Imath::half> halves_[5];
    std::vector<unsigned> integers_[5];
};

TEST_F(ExrFiles, EveryLosslessCompressionInLinesAndTiles) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION})
        for (const bool tiled : {false, true})
            for (const Imf::PixelType type : {Imf::HALF, Imf::UINT}) {
                SCOPED_TRACE(testing::Message() << "compression " << compression << " tiled " << tiled << " type " << type);
                Layout layout;
                layout.compression = compression, layout.tiled = tiled, layout.type = type;
                write(layout);
                expect_pixels(layout);
            }
}

/// The picture is what the display window shows: data outside it is dropped, and where there is no data it is 0.
TEST_F(ExrFiles, WindowsMayDiffer) {
    const Box2i display(V2i(-3, 2), V2i(10, 9));
    const Box2i datas[] = {{V2i(-3, 2), V2i(10, 9)}, {V2i(0, 4), V2i(5, 6)}, {V2i(-10, -5), V2i(15, 15)}, {V2i(5, 0), V2i(15, 5)}, {V2i(-9, 3), V2i(-4, 5)}};
    for (const Box2i& data : datas) {
        SCOPED_TRACE(testing::Message() << data.min.x << "," << data.min.y << " to " << data.max.x << "," << data.max.y);
        Layout layout;
        layout.data = data, layout.display = display;
        write(layout);
        expect_pixels(layout);
    }
}

TEST_F(ExrFiles, FurtherPartsComeAfterTheFirst) {
    Layout layout;
    std::vector<Imf::Header> headers(2, header(layout));
    headers[0].setName("first"), headers[1].setName("second");
    headers[1].channels().insert("extra", Imf::Channel(Imf::HALF));
    for (Imf::Header& h : headers) h.setType(Imf::SCANLINEIMAGE);
    {
        Imf::MultiPartOutputFile file(path_.c_str(), headers.data(), 2);
        for (int part = 0; part < 2; ++part) {
            Imf::OutputPart out(file, part);
            out.setFrameBuffer(frame(layout));
            out.writePixels(9);
        }
    }
    expect_pixels(layout, {"second.R", "second.G", "second.B", "second.A", "second.Z", "second.extra"});
}

/// Depth, layers and further parts are no alpha.
TEST(Colors, AreTakenByTheirNames) {
    const auto alone = [](std::vector<std::string> names) {
        Picture picture(1, 1, std::move(names));
        for (size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = float(i);
        return colors_alone(std::move(picture));
    };
    for (const auto& [has, names, values] : {std::tuple<std::vector<std::string>, std::vector<std::string>, std::vector<float>>{{"R", "G", "B", "Z"}, {"R", "G", "B"}, {0, 1, 2}},
                                             {{"B", "G", "R", "A"}, {"R", "G", "B", "A"}, {2, 1, 0, 3}},
                                             {{"Y", "Z"}, {"Y"}, {0}},
                                             {{"Z", "A", "Y", "back.R"}, {"Y", "A"}, {2, 1}},
                                             {{"R", "G", "B", "back.R", "back.A"}, {"R", "G", "B"}, {0, 1, 2}}}) {
        const auto picture = alone(has);
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->names, names);
        EXPECT_EQ(picture->values, values);
    }
    const auto none = alone({"depth.Z", "A"});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error(), "it has no channels R, G, B or Y: its channels are depth.Z, A");
}

TEST_F(ExrFiles, SubsampledChannelsAreRefusedByName) {
    Layout layout;
    layout.data = layout.display = Box2i(V2i(0, 0), V2i(7, 7));
    Imf::Header head = header(layout);
    head.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
    { Imf::OutputFile file(path_.c_str(), head, 0); }   // no pixels: the header is enough
    const auto picture = read_picture(path_, Encoding::automatic);
    ASSERT_FALSE(picture);
    EXPECT_THAT(picture.error(), testing::HasSubstr("RY is subsampled"));
}

}  // namespace
}  // namespace alidade

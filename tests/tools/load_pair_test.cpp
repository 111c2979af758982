// SPDX-License-Identifier: Apache-2.0
/// What two files have to say to each other before anything is measured: channels, parts, alpha, what is no number.
#include "tests/core/folder_test.h"
#include "tools/diff/words.h"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>

namespace alidade::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();

class LoadPair : public FolderTest {
  protected:
    /// Channels with these values everywhere, but `odd` of them at one pixel.
    Picture picture(const std::vector<std::string>& names, const std::vector<float>& values, const std::vector<float>& odd = {}) {
        Picture out(32, 24, names);
        for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = values[i % values.size()];
        if (!odd.empty()) std::copy(odd.begin(), odd.end(), out.at(5, 7));
        return out;
    }
    std::string file(const std::string& name, const Picture& picture) {
        const std::string path = (folder_ / name).string();
        const auto written = write_picture(path, picture);
        EXPECT_TRUE(written) << (written ? "" : written.error());
        return path;
    }
    Comparison compare(const std::string& reference, const std::string& test, const std::string& layer = "") {
        DiffRequest request;
        request.pair.layer = layer;
        set_default_rules(request.rules, "exact");
        return compare_files(reference, test, request);
    }
};

/// EXR sorts a layer's channels by name: A, B, G, R.
TEST_F(LoadPair, ALayersColoursAreAllCompared) {
    const std::vector<std::string> names{"L.A", "L.B", "L.G", "L.R"};
    const auto a = file("a.exr", picture(names, {1, 0.5F, 0.25F, 0.125F})), b = file("b.exr", picture(names, {1, 0.5F, 0.25F, 0.375F}));
    const Comparison found = compare(a, b, "L");
    EXPECT_EQ(found.judgement.verdict, Verdict::fail);
    EXPECT_FLOAT_EQ(float(*found.measured.at("bias").find("R")), 0.25F);
    EXPECT_EQ(compare(a, a, "L").judgement.verdict, Verdict::pass);
}

TEST_F(LoadPair, ALayerThatIsNoColourIsComparedByChannel) {
    const std::vector<std::string> names{"V.W", "V.X", "V.Y", "V.Z"};
    const auto a = file("a.exr", picture(names, {1, 2, 3, 4})), b = file("b.exr", picture(names, {1, 2, 3, 5}));
    const Comparison refused = compare(a, b, "V");
    EXPECT_EQ(refused.judgement.verdict, Verdict::error);
    EXPECT_THAT(refused.judgement.reason, HasSubstr("has 4 channels, which are no colours: --layer V.W compares one of them"));
    EXPECT_EQ(compare(a, b, "V.Y").judgement.verdict, Verdict::pass);
    EXPECT_EQ(compare(a, b, "V.Z").judgement.verdict, Verdict::fail);
}

TEST_F(LoadPair, ALayerOfTwoNumbersIsCompared) {
    const auto a = file("a.exr", picture({"uv.U", "uv.V"}, {0.25F, 0.5F})), b = file("b.exr", picture({"uv.U", "uv.V"}, {0.25F, 0.5F}, {0.25F, 0.75F}));
    EXPECT_EQ(compare(a, a, "uv").judgement.verdict, Verdict::pass);
    const Comparison found = compare(a, b, "uv");
    EXPECT_EQ(found.judgement.verdict, Verdict::fail);
    EXPECT_EQ(*found.measured.at("max_abs").find("value"), 0.25);
}

/// Of the two channels, not of a third that nobody has; nor of one that is 0 in the other file.
TEST_F(LoadPair, MeansOfTwoNumbersAreOfTwo) {
    const auto a = file("a.exr", picture({"n.U", "n.V"}, {0.25F, 0.5F})), b = file("b.exr", picture({"n.U", "n.V"}, {0.5F, 0.5F}));
    const Comparison found = compare(a, b, "n");
    EXPECT_FLOAT_EQ(float(*found.measured.at("mae").find("value")), 0.125F);
    EXPECT_FLOAT_EQ(float(*found.measured.at("rmse").find("value")), 0.25F / std::sqrt(2.0F));
    EXPECT_EQ(found.loaded->pair.reference.channels, 2);
    const auto three = file("c.exr", picture({"n.X", "n.Y", "n.Z"}, {0.25F, 0.5F, 0})), one = file("d.exr", picture({"n.Y"}, {0.25F})), gray = file("e.exr", picture({"n.X", "n.Y", "n.Z"}, {0.25F}));
    for (const auto& [reference, test] : {std::pair(a, three), std::pair(three, a), std::pair(a, one), std::pair(one, a), std::pair(a, gray)}) {
        const Comparison refused = compare(reference, test, "n");
        EXPECT_EQ(refused.judgement.verdict, Verdict::incomparable) << reference << " " << test;
        EXPECT_EQ(refused.cause.name, "channels");
    }
    EXPECT_EQ(compare(one, gray, "n").judgement.verdict, Verdict::pass);
}

/// The report and the heat map show what is no number, and what differs in alpha alone.
TEST_F(LoadPair, WhatIsNoNumberIsKeptForShowing) {
    const auto a = file("a.exr", picture({"R", "G", "B"}, {0.5F, 0.5F, 0.5F})), b = file("b.exr", picture({"R", "G", "B"}, {0.5F, 0.5F, 0.5F}, {kNan, 0.5F, 0.5F}));
    const Comparison found = compare(a, b);
    const size_t odd = 7 * 32 + 5;
    ASSERT_EQ(found.loaded->odd.size(), 32u * 24);
    EXPECT_EQ(error_map(found)[odd], 1);
    EXPECT_EQ(std::count(found.loaded->odd.begin(), found.loaded->odd.end(), 1), 1);
    EXPECT_TRUE(std::isnan(found.loaded->shown[1].values[3 * odd]));
    EXPECT_EQ(found.loaded->shown[0].values[3 * odd], 0.5F);
    const auto c = file("c.exr", picture({"R", "G", "B", "A"}, {0, 0, 0, 0.5F})), d = file("d.exr", picture({"R", "G", "B", "A"}, {0, 0, 0, 0.5F}, {0, 0, 0, 0.125F}));
    EXPECT_EQ(error_map(compare(c, d))[odd], 0.375F);
}

/// What is no number is found even in channels that the other file does not have.
TEST_F(LoadPair, NanInAlphaOrInOneColourIsNotLost) {
    const auto opaque = file("o.exr", picture({"R", "G", "B"}, {0.5F, 0.5F, 0.5F}));
    const auto gray = file("g.exr", picture({"Y"}, {0.5F}));
    for (const float odd : {kNan, kInfinite}) {
        const auto alpha = file("alpha.exr", picture({"R", "G", "B", "A"}, {0.5F, 0.5F, 0.5F, 1}, {0.5F, 0.5F, 0.5F, odd}));
        const auto green = file("green.exr", picture({"R", "G", "B"}, {0.5F, 0.5F, 0.5F}, {0.5F, odd, 0.5F}));
        for (const auto& [reference, test] : {std::pair(opaque, alpha), std::pair(gray, green), std::pair(gray, alpha)}) {
            const Comparison found = compare(reference, test);
            EXPECT_EQ(found.judgement.verdict, Verdict::fail) << test;
            EXPECT_THAT(found.judgement.reason, HasSubstr("in the test alone: 1 pixels, the first at 5,7"));
        }
    }
}

TEST_F(LoadPair, NanAgainstInfinityIsTheNansFault) {
    const auto nan = file("n.exr", picture({"Y"}, {0.5F}, {kNan})), infinite = file("i.exr", picture({"Y"}, {0.5F}, {kInfinite}));
    EXPECT_THAT(compare(nan, infinite).judgement.reason, HasSubstr("NaN in the reference alone"));
    EXPECT_THAT(compare(infinite, nan).judgement.reason, HasSubstr("NaN in the test alone"));
}

TEST_F(LoadPair, TheSameInfinityEverywhereIsEqual) {
    const auto empty = file("e.exr", picture({"Y"}, {kInfinite}));
    EXPECT_EQ(compare(empty, empty).judgement.verdict, Verdict::pass);
}

/// What a crop leaves out has no say in whether the files fit.
TEST_F(LoadPair, ACropComesFirst) {
    const Picture plain = picture({"R", "G", "B"}, {0.5F, 0.5F, 0.5F});
    const auto a = file("a.exr", plain), b = file("b.exr", picture({"R", "G", "B", "A"}, {0.5F, 0.5F, 0.5F, 1}, {0.25F, 0.25F, 0.25F, 0.5F}));
    EXPECT_EQ(compare(a, b).judgement.verdict, Verdict::incomparable);
    DiffRequest request;
    request.pair.x0 = 6, request.pair.y0 = 0, request.pair.x1 = 32, request.pair.y1 = 24;
    set_default_rules(request.rules, "exact");
    EXPECT_EQ(compare_files(a, b, request).judgement.verdict, Verdict::pass);
}

/// The same bytes in files of different formats are the same picture, to the last digit.
TEST_F(LoadPair, FormatsOfTheSameStepsAgree) {
    Picture ramp(32, 24, {"R", "G", "B"});
    for (size_t i = 0; i < ramp.values.size(); ++i) ramp.values[i] = float(srgb_to_linear(double(i % 256) / 255));
    const auto png = file("a.png", ramp);
    for (const char* name : {"a.tif", "a.bmp", "a.ppm"}) {
        const Comparison found = compare(png, file(name, ramp));
        EXPECT_EQ(found.judgement.verdict, Verdict::pass) << name << ": " << found.judgement.reason;
    }
}

/// A file of two parts, one number each.
std::string two_parts(const std::string& path, float first, float second) {
    std::vector<Imf::Header> headers(2, Imf::Header(4, 3));
    for (size_t i = 0; i < 2; ++i) {
        headers[i].setName(i ? "right" : "left"), headers[i].setType(Imf::SCANLINEIMAGE);
        for (const char* channel : {"R", "G", "B"}) headers[i].channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
        std::vector<float> values(12, i ? second : first);
        Imf::FrameBuffer frame;
        for (const char* channel : {"R", "G", "B"}) frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), 4 * sizeof(float)));
        Imf::OutputPart part(file, i);
        part.setFrameBuffer(frame);
        part.writePixels(3);
    }
    return path;
}

TEST_F(LoadPair, FurtherPartsAreLayers) {
    const auto a = two_parts((folder_ / "a.exr").string(), 0.5F, 0.25F), b = two_parts((folder_ / "b.exr").string(), 0.5F, 0.75F);
    const Comparison colours = compare(a, b);
    EXPECT_EQ(colours.judgement.verdict, Verdict::pass);
    EXPECT_THAT(colours.loaded->notes, Contains(HasSubstr("3 other channels are not")));
    EXPECT_EQ(compare(a, b, "right").judgement.verdict, Verdict::fail);
    EXPECT_EQ(compare(a, a, "right").judgement.verdict, Verdict::pass);
}

/// One number everywhere in 6 x 5 pixels, of which 4 x 3 are displayed.
std::string with_surroundings(const std::string& path, bool other_primaries) {
    Imf::Header header(4, 3);
    header.dataWindow() = Imath::Box2i({-1, -1}, {4, 3});
    Imf::Chromaticities wide;
    wide.red = {0.7F, 0.29F};
    if (other_primaries) Imf::addChromaticities(header, wide);
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    std::vector<float> values(30, 0.5F);
    Imf::FrameBuffer frame;
    for (const char* channel : {"R", "G", "B"}) frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow(), sizeof(float), 6 * sizeof(float)));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(5);
    return path;
}

std::string of_integers(const std::string& path, unsigned value) {
    Imf::Header header(4, 3);
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    std::vector<unsigned> values(12, value);
    Imf::FrameBuffer frame;
    frame.insert("id", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(values.data()), sizeof(unsigned), 4 * sizeof(unsigned)));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(3);
    return path;
}

TEST_F(LoadPair, IntegersThatFloatsRoundAreTold) {
    const auto a = of_integers((folder_ / "a.exr").string(), 20000000), small = of_integers((folder_ / "b.exr").string(), 16777215);
    EXPECT_THAT(compare(a, a, "id").loaded->notes, Contains(HasSubstr("the last digits of integers")));
    EXPECT_TRUE(compare(small, small, "id").loaded->notes.empty());
}

TEST_F(LoadPair, WhatAFileSaysBesidesIsTold) {
    const auto a = with_surroundings((folder_ / "a.exr").string(), false), b = with_surroundings((folder_ / "b.exr").string(), true);
    const Comparison found = compare(a, b);
    EXPECT_EQ(found.judgement.verdict, Verdict::pass);
    EXPECT_THAT(found.loaded->notes, Contains(AllOf(HasSubstr("b.exr"), HasSubstr("chromaticities"))));
    EXPECT_THAT(found.loaded->notes, Contains(AllOf(HasSubstr("a.exr"), HasSubstr("outside of its display window"))));
    EXPECT_THAT(found.loaded->notes, Not(Contains(AllOf(HasSubstr("a.exr"), HasSubstr("chromaticities")))));
    const auto plain = file("p.exr", picture({"R", "G", "B"}, {0.5F}));
    EXPECT_TRUE(compare(plain, plain).loaded->notes.empty());
}

}  // namespace
}  // namespace alidade::test

// SPDX-License-Identifier: Apache-2.0
#include "tools/values.h"

#include "tools/verbs.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(ParseSize, TakesWidthAndHeight) {
    const auto size = parse_size("640x480");
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 640);
    EXPECT_EQ(size->height, 480);
    EXPECT_TRUE(parse_size("1x1"));
    EXPECT_TRUE(parse_size("32768x32768"));
}

TEST(ParseSize, RefusesEverythingElse) {
    for (const char* word : {"", "x", "640", "640x", "x480", "0x480", "640x0", "-1x5", "640X480", "640x480x3", "6 40x480", "1e3x5", "99999999999x1"})
        EXPECT_FALSE(parse_size(word)) << word;
    EXPECT_THAT(parse_size("12by3").error(), HasSubstr("'12by3' is not WIDTHxHEIGHT"));
    EXPECT_THAT(parse_size("32769x32768").error(), HasSubstr("more than 1073741824 pixels"));
}

TEST(ParseRegion, TakesTwoCorners) {
    const auto region = parse_region("1,2,30,40");
    ASSERT_TRUE(region);
    EXPECT_EQ(region->x0, 1);
    EXPECT_EQ(region->y0, 2);
    EXPECT_EQ(region->x1, 30);
    EXPECT_EQ(region->y1, 40);
}

TEST(ParseRegion, RefusesEmptyAndBroken) {
    for (const char* word : {"", "1,2,3", "1,2,3,4,5", "1,2,1,4", "5,2,3,4", "1,2,3,2", "-1,0,3,4", "a,b,c,d", "1,2,3,4,", "1;2;3;4"})
        EXPECT_FALSE(parse_region(word)) << word;
}

TEST(ParseColor, IsTheWebsColourMadeLinear) {
    EXPECT_EQ(*parse_color("#fff"), Color(1));
    EXPECT_EQ(*parse_color("#000000"), Color(0));
    const auto orange = parse_color("#ff8000");
    ASSERT_TRUE(orange);
    EXPECT_EQ(orange->x, 1);
    EXPECT_NEAR(orange->y, std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-7);   // IEC 61966-2-1
    EXPECT_EQ(orange->z, 0);
    EXPECT_EQ(*parse_color("#abc"), *parse_color("#aabbcc"));
    for (const char* word : {"", "#", "fff", "#ff", "#ffff", "#gggggg", "#-1-1-1", "#12345", "sky.hdr", "#ff ff "}) EXPECT_FALSE(parse_color(word)) << word;
}

TEST(ParseInteger, KeepsItsBounds) {
    EXPECT_EQ(*parse_integer("0", 0, 10), 0);
    EXPECT_EQ(*parse_integer("10", 0, 10), 10);
    EXPECT_EQ(*parse_integer("-3", -5, 5), -3);
    for (const char* word : {"", "11", "-1", "1.0", "1e1", " 1", "1 ", "0x1", "99999999999999999999"}) EXPECT_FALSE(parse_integer(word, 0, 10)) << word;
}

TEST(ParseNumber, IsFinite) {
    EXPECT_EQ(*parse_number("-1.5e2", -1e9), -150);
    EXPECT_EQ(*parse_number("0", 0), 0);
    EXPECT_THAT(parse_number("-1e-9", 0).error(), HasSubstr("less than 0"));
    EXPECT_EQ(*parse_number("180", 0, 180), 180);
    EXPECT_THAT(parse_number("180.5", 0, 180).error(), HasSubstr("more than 180"));
    for (const char* word : {"", "nan", "inf", "-inf", "1e999", "1,5", "1.5x", " 1"}) EXPECT_FALSE(parse_number(word, -1e9)) << word;
}

TEST(Nearest, FindsTheLikelySlip) {
    const std::vector<std::string> options{"--size", "--spp", "--seed", "--region", "--integrator"};
    EXPECT_EQ(nearest("--siez", options), "--size");         // a swap
    EXPECT_EQ(nearest("--sze", options), "--size");          // a letter left out
    EXPECT_EQ(nearest("--regoin", options), "--region");
    EXPECT_EQ(nearest("--integratro", options), "--integrator");
    EXPECT_EQ(nearest("--output", options), "");
    EXPECT_EQ(nearest("", options), "");
}

}  // namespace
}  // namespace alidade

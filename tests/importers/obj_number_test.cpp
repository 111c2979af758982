// SPDX-License-Identifier: Apache-2.0
/// Numbers as OBJ files write them, against the C library.
#include "importers/mesh/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace alidade::mesh {
namespace {

std::optional<Number> read(const std::string& text) { return TextCursor(text).number(); }

std::string random_decimal(std::mt19937_64& random) {
    std::string text = random() % 3 ? "" : "-";
    const size_t whole = random() % 12, fraction = random() % (whole ? 20 : 19) + (whole ? 0 : 1);
    for (size_t i = 0; i < whole; ++i) text += char('0' + random() % 10);
    if (fraction || random() % 2) text += '.';
    for (size_t i = 0; i < fraction; ++i) text += char('0' + random() % 10);
    if (random() % 3 == 0) text += "e" + std::to_string(int(random() % 700) - 350);
    return text;
}

TEST(ObjNumbers, AreTheNearestDouble) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300000; ++i) {
        const std::string text = random_decimal(random);
        if (text == "-." || text == ".") continue;
        const std::optional<Number> got = read(text);
        ASSERT_TRUE(got) << text;
        double want = std::strtod(text.c_str(), nullptr);
        ASSERT_EQ(std::memcmp(&got->value, &want, sizeof want), 0) << text << " read as " << got->value << ", should be " << want;
    }
}

TEST(ObjNumbers, SpecialSpellings) {
    for (const char* text : {"nan", "-nan", "NaN", "nan(ind)", "1.#IND", "-1.#IND", "1.#QNAN"}) EXPECT_TRUE(std::isnan(read(text).value().value)) << text;
    for (const char* text : {"inf", "INFINITY", "1.#INF", "1e999", "+inf", "1e99999999999999"}) EXPECT_EQ(read(text).value().value, INFINITY) << text;
    EXPECT_EQ(read("-inf").value().value, -INFINITY);
    EXPECT_EQ(read("1e-999").value().value, 0);
    EXPECT_EQ(read("0e999999").value().value, 0);
    EXPECT_EQ(read("5.").value().value, 5);
    EXPECT_EQ(read("+.5E+1").value().value, 5);
    EXPECT_TRUE(std::signbit(read("-0").value().value));
    for (const char* text : {"", "x", "1x", "1.2.3", "1e", "1e+", "-", ".", "e5", "0x1", "1,5", "infx", "#1"}) EXPECT_FALSE(read(text)) << text;
}

TEST(ObjNumbers, RefusedOnesLeaveTheCursor) {
    TextCursor cursor("12 x7");
    EXPECT_EQ(cursor.number()->value, 12);
    EXPECT_FALSE(cursor.number());
    EXPECT_EQ(cursor.word(), "x7");
}

}  // namespace
}  // namespace alidade::mesh

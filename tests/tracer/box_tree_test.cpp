// SPDX-License-Identifier: Apache-2.0
#include "tracer/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace alidade {
namespace {

class Boxes : public testing::TestWithParam<int> {
  protected:
    double in_unit() { return std::uniform_real_distribution<double>()(random_); }
    Vec3 point() { return {in_unit(), in_unit(), in_unit()}; }
    /// `endless` of them reach to infinity on one side or on all.
    std::vector<Bounds> some(size_t count, double size, size_t endless) {
        std::vector<Bounds> boxes;
        for (size_t i = 0; i < count; ++i) {
            const Vec3 at = point();
            boxes.push_back({at, at + size * point()});
            if (i % 7 == 3) boxes.back().max.y = boxes.back().min.y;
            if (i < endless) boxes.back().max[int(i % 3)] = kInf;
            if (i < endless && i % 2) boxes.back().min = Vec3(-kInf);
        }
        std::ranges::shuffle(boxes, random_);
        return boxes;
    }

  private:
    std::mt19937 random_{unsigned(GetParam())};
};

TEST_P(Boxes, ThatHoldAPointAreFound) {
    for (const size_t count : {0, 1, 2, 3, 50, 700}) {
        const std::vector<Bounds> boxes = some(count, 0.3, count / 5);
        const BoxTree tree(boxes);
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = i % 3 || boxes.empty() ? point() : boxes[size_t(i) % count].min;     // corners are in closed boxes
            std::vector<uint32_t> found, wanted;
            tree.holding(p, [&](uint32_t n) { found.push_back(n); });
            for (uint32_t n = 0; n < count; ++n)
                if (boxes[n].contains(p)) wanted.push_back(n);
            std::ranges::sort(found);
            EXPECT_EQ(found, wanted);
        }
    }
}

TEST_P(Boxes, ThatAreManyAreNotAllAsked) {
    const BoxTree tree(some(20000, 0.03, 8));
    size_t asked = 0;
    for (int i = 0; i < 100; ++i) asked += tree.holding(point(), [](uint32_t) {});
    EXPECT_LT(asked, 100 * 200u);
}

TEST_P(Boxes, InOnePlaceMakeATree) {
    const std::vector<Bounds> boxes(5000, Bounds{Vec3(0), Vec3(1)});
    int found = 0;
    EXPECT_EQ(BoxTree(boxes).holding(Vec3(1), [&](uint32_t) { ++found; }), 9999u);
    EXPECT_EQ(found, 5000);
    EXPECT_EQ(BoxTree(boxes).holding(Vec3(2), [&](uint32_t) { ++found; }), 1u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Boxes, testing::Range(1, 4));

}  // namespace
}  // namespace alidade

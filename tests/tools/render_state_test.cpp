// SPDX-License-Identifier: Apache-2.0
/// The file of finished tiles: what is read from it is what was written, or nothing. Damage is tried at every byte.
#include "tools/render_state.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <set>

namespace alidade {
namespace {

using testing::HasSubstr;

const Identity kPlain = {{"size", "7x5"}, {"scene", "a"}};

class RenderStateFile : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "alidade_state_XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        path = (folder / "p.pov-state").string();
        RenderOptions options;
        options.width = 7, options.height = 5, options.tile = 3;   // 3 x 2 tiles, those at the right and below cut off
        grid = *tile_grid(options);
        picture = Picture(7, 5, {"R", "G", "B"});
        for (size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = float(i) + 0.25f;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::unique_ptr<RenderState> open(bool continued, const Identity& identity = kPlain) {
        said.clear();
        return RenderState::open(path, grid, 3, identity, continued, [this](const std::string& sentence) { said += sentence + '\n'; });
    }
    /// A state with the tiles of `order`; its bytes.
    std::vector<std::byte> written(const std::vector<size_t>& order) {
        const auto state = open(false);
        for (const size_t tile : order) state->keep(tile, picture);
        return *read_file(path);
    }
    /// Opens `bytes`: which tiles are known. Every pixel of these is as it was kept, the others are as they were.
    std::set<size_t> known(std::span<const std::byte> bytes, const Identity& identity = kPlain) {
        EXPECT_TRUE(write_file(path, bytes));
        const auto state = open(true, identity);
        std::set<size_t> tiles;
        for (size_t tile = 0; tile < grid.count(); ++tile) {
            Picture got(7, 5, picture.names), want = got;
            if (state->recall(tile, got)) {
                tiles.insert(tile);
                const Region r = grid.tile(tile);
                for (int y = r.y0; y < r.y1; ++y) std::copy_n(picture.at(r.x0, y), 3 * (r.x1 - r.x0), want.at(r.x0, y));
            }
            EXPECT_EQ(got.values, want.values) << "tile " << tile;
        }
        EXPECT_EQ(tiles.size(), state->known());
        return tiles;
    }

    std::filesystem::path folder;
    std::string path, said;
    TileGrid grid;
    Picture picture;
};

TEST_F(RenderStateFile, GivesBackWhatWasKept) {
    EXPECT_EQ(known(written({4, 0, 5})), (std::set<size_t>{0, 4, 5}));
    EXPECT_EQ(said, "");
    const auto all = written({0, 1, 2, 3, 4, 5});
    EXPECT_EQ(known(all).size(), 6u);
    EXPECT_EQ(written({}).size() + 6 * 12 + 7 * 5 * 3 * 4, all.size()) << "a record is its tile's number, pixels and checksum";
}

TEST_F(RenderStateFile, GoesOnAfterWhatIsThere) {
    const auto whole = written({1, 2, 3});
    written({1, 2});
    open(true)->keep(3, picture);
    EXPECT_EQ(*read_file(path), whole);
    open(false);
    EXPECT_EQ(*read_file(path), written({})) << "begun anew";
    const auto state = open(false);
    state->remove();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RenderStateFile, CutAnywhereItLosesItsTail) {
    const auto bytes = written({1, 2, 3});
    const size_t ends[] = {written({}).size(), written({1}).size(), written({1, 2}).size(), bytes.size()};
    const std::set<size_t> sets[] = {{}, {1}, {1, 2}, {1, 2, 3}};
    for (size_t size = 0; size <= bytes.size(); ++size) {
        const auto whole = std::upper_bound(std::begin(ends), std::end(ends), size) - std::begin(ends);
        EXPECT_EQ(known(std::span(bytes).first(size)), whole ? sets[whole - 1] : std::set<size_t>()) << size;
        EXPECT_EQ(said.empty(), whole > 0 || size == 0) << size << ": " << said;
        EXPECT_EQ(std::filesystem::file_size(path), ends[std::max<std::ptrdiff_t>(whole, 1) - 1]) << "what follows is written after good bytes";
    }
}

TEST_F(RenderStateFile, DamagedAnywhereItIsNotUsed) {
    const auto bytes = written({1, 2, 3});
    const size_t last = written({1, 2}).size();
    for (size_t i = 0; i < bytes.size(); ++i)
        for (const int bit : {0, 7}) {
            auto damaged = bytes;
            damaged[i] ^= std::byte(1 << bit);
            const auto tiles = known(damaged);
            // Another number of a larger tile in the last record looks like one that was cut off.
            if (said.empty()) EXPECT_TRUE(i >= last && i < last + 4 && tiles == (std::set<size_t>{1, 2})) << i;
            else EXPECT_TRUE(tiles.empty()) << i;
        }
}

TEST_F(RenderStateFile, RecordsOfAnotherFileDoNotCount) {
    auto bytes = written({1, 2});
    const size_t head = written({}).size();
    { open(false, {{"size", "7x5"}, {"scene", "b"}})->keep(1, picture); }
    auto other = *read_file(path);
    std::copy(bytes.begin() + std::ptrdiff_t(head), bytes.end(), std::back_inserter(other));   // of the same tiles, in another scene
    other.erase(other.begin() + std::ptrdiff_t(head), other.begin() + std::ptrdiff_t(written({1}).size()));
    EXPECT_TRUE(known(other, {{"size", "7x5"}, {"scene", "b"}}).empty());
    EXPECT_THAT(said, HasSubstr("it is damaged at byte"));
}

TEST_F(RenderStateFile, TheSameTileTwiceIsDamage) {
    auto bytes = written({1});
    const auto once = bytes;
    std::copy(once.begin() + std::ptrdiff_t(written({}).size()), once.end(), std::back_inserter(bytes));
    EXPECT_TRUE(known(bytes).empty());
    EXPECT_THAT(said, HasSubstr("it is damaged at byte"));
}

TEST_F(RenderStateFile, SaysWhatIsOfAnotherPicture) {
    const auto bytes = written({1});
    EXPECT_TRUE(known(bytes, {{"size", "7x6"}, {"scene", "a"}}).empty());
    EXPECT_THAT(said, HasSubstr("it is of another picture: its size is 7x5, not 7x6; the picture is made from its beginning"));
    EXPECT_TRUE(known(bytes, {{"size", "7x5"}, {"scene", "b"}}).empty());
    EXPECT_THAT(said, HasSubstr("its scene is a, not b"));
    EXPECT_TRUE(known(bytes, {{"size", "7x5"}}).empty());
    EXPECT_THAT(said, HasSubstr("it is of another picture;"));
    EXPECT_TRUE(known(bytes, {{"sizes", "7x5"}, {"scene", "a"}}).empty());
    EXPECT_THAT(said, HasSubstr("it is of another picture;"));
}

/// A head that claims much is read no further than there is file.
TEST_F(RenderStateFile, AllocatesNothingThatIsMerelyClaimed) {
    auto bytes = written({1});
    for (size_t i = 16; i < 20; ++i) bytes[i] = std::byte(0xff);
    EXPECT_TRUE(known(bytes).empty());
    EXPECT_THAT(said, HasSubstr("its head is damaged"));
}

}  // namespace
}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/toy_scenes.h"

#include <fmt/format.h>

#include <cfenv>

namespace alidade::numerics {

namespace {

/// The scenes as they are, rendered once each.
class Originals {
  public:
    const Picture& operator[](size_t number) {
        Picture& picture = pictures_.try_emplace(number).first->second;
        if (picture.values.empty()) picture = toy_picture(toy_scene(number));
        return picture;
    }

  private:
    std::map<size_t, Picture> pictures_;
};

bool shows_something(const Picture& p) {
    const auto [low, high] = std::minmax_element(p.values.begin(), p.values.end());
    return !p.values.empty() && *high > *low + 0.1f;
}

/// Pixels that differ by more than 2/255 where white is 1.
size_t pixels_off(const Picture& a, const Picture& b) {
    if (a.values.size() != b.values.size()) return a.values.size();
    size_t off = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            double most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(std::clamp(double(a.at(x, y)[c]), 0.0, 1.0) - std::clamp(double(b.at(x, y)[c]), 0.0, 1.0)));
            off += !(most <= 2.0 / 255);
        }
    }
    return off;
}

/// How a world is scaled, and what may change.
struct Scaled {
    double factor;
    bool baked;       ///< the numbers themselves, and not by a transform of the root
    bool same_bits;   ///< of the whole picture; or no pixel more than 2/255 off
};

Scaled scaled(Draws& draws) {
    switch (draws.below(4)) {
        case 0: return {std::pow(10, draws.uniform(-12, 12)), false, false};
        case 1: {
            const int power = int(draws.below(81)) - 40;
            return {std::ldexp(1.0, power), true, std::abs(power) <= 20};
        }
        default: return {std::ldexp(1.0, int(draws.below(81)) - 40), false, true};
    }
}

}  // namespace

Check scale_image() {
    return [originals = std::make_shared<Originals>()](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(12, 0, number));
        const size_t scene = number % toy_scene_count();
        const Scaled s = scaled(draws);
        tally.at(NumericsScale::size, s.factor);
        const Picture& before = (*originals)[scene];
        std::feclearexcept(FE_UNDERFLOW);   // a number that lost digits below the least normal one would show what float can hold, and not what we can
        const Picture after = toy_picture(s.baked ? baked_toy_scene(scene, s.factor) : toy_scene(scene, s.factor));
        const bool held = !std::fetestexcept(FE_UNDERFLOW);
        const size_t off = shows_something(before) ? pixels_off(before, after) : before.values.size();
        tally.decide(held && off == 0 && (!s.same_bits || before.values == after.values), [&] {
            return fmt::format("{}, {} by {:a}: {} pixels are more than 2/255 off{}{}", toy_scene_name(scene), s.baked ? "baked" : "a root scaled", s.factor, off, before.values == after.values ? "" : ", other bits", held ? "" : ", underflow");
        });
    };
}

Check offset_image() {
    return [originals = std::make_shared<Originals>()](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(13, 0, number));
        const size_t scene = number % toy_scene_count();
        const double distance = std::pow(10, draws.uniform(2, 9));
        tally.at(NumericsScale::offset, distance);
        const Picture& before = (*originals)[scene];
        const Picture after = toy_picture(toy_scene(scene, 1, draws.direction() * distance));
        const size_t off = shows_something(before) ? pixels_off(before, after) : before.values.size();
        tally.measure(double(off), distance <= 1e7 ? 0 : 1.2, [&] { return fmt::format("{}, moved by {:.3g}: {} pixels of 1200 are more than 2/255 off", toy_scene_name(scene), distance, off); });
    };
}

Check determinism() {
    return [originals = std::make_shared<Originals>()](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(25, 0, number));
        const size_t scene = number % toy_scene_count();
        RenderOptions options;
        CompileOptions compile_options;
        options.threads = compile_options.threads = 1 + int(draws.below(8)), options.tile = 1 << draws.below(7);
        const auto names = accelerators();
        compile_options.accel = names[draws.below(names.size())].name;
        const auto isas = available_isas();
        compile_options.isa = isas[draws.below(isas.size())];
        const Picture after = toy_picture(toy_scene(scene), compile_options, options);
        tally.decide(shows_something(after) && (*originals)[scene].values == after.values, [&] {
            return fmt::format("{}: {} threads, tiles of {}, {}, {}", toy_scene_name(scene), options.threads, options.tile, compile_options.accel, name(compile_options.isa));
        });
    };
}

}  // namespace alidade::numerics

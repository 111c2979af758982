// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/load_pair.h"

#include "core/header_size.h"
#include "core/image_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade {
namespace {

using Refused = tl::unexpected<NoPair>;

Refused bad_file(std::string sentence) { return Refused({false, "file", std::move(sentence)}); }
Refused incomparable(const char* cause, std::string sentence) { return Refused({true, cause, std::move(sentence)}); }

/// A file's channels that are compared, and what their numbers mean.
struct Side {
    Picture picture;       ///< Y, or R, G, B, or R, G for two numbers; then A
    uint32_t levels = 0;
    double gamma = 0;
    bool premultiplied = false;
    size_t others = 0;     ///< channels that are left out
    std::vector<std::string> left_out;   ///< as in StoredPicture
};

int channel_at(const Picture& picture, const std::string& name) {
    const auto found = std::find(picture.names.begin(), picture.names.end(), name);
    return found == picture.names.end() ? -1 : int(found - picture.names.begin());
}

/// The channels of a layer: R, G, B (files sort them as B, G, R) and A, X, Y, Z, or as the file has them.
std::vector<int> layer_channels(const Picture& picture, const std::string& layer) {
    std::vector<int> all;
    for (size_t c = 0; c < picture.names.size(); ++c)
        if (picture.names[c].rfind(layer + ".", 0) == 0 || picture.names[c] == layer) all.push_back(int(c));
    for (const std::vector<std::string>& usual : {std::vector<std::string>{"R", "G", "B", "A"}, {"R", "G", "B"}, {"X", "Y", "Z"}}) {
        std::vector<int> found;
        for (const std::string& name : usual) found.push_back(channel_at(picture, layer + "." + name));
        if (found.size() == all.size() && std::find(found.begin(), found.end(), -1) == found.end()) return found;
    }
    return all;
}

/// Others of two channels are two numbers, as texture coordinates.
bool is_gray_with_alpha(const Picture& picture, const std::vector<int>& channels) {
    return channels.size() == 2 && (picture.names[size_t(channels[1])] == "A" || picture.names[size_t(channels[1])].ends_with(".A"));
}

/// One to three numbers can be compared as colours are, and one or three with alpha.
bool is_comparable(const Picture& picture, const std::vector<int>& channels) {
    return channels.size() <= 3 || (channels.size() == 4 && picture.names[size_t(channels[3])].ends_with(".A"));
}

tl::expected<Side, NoPair> read_side(const std::string& path, const std::string& layer) {
    auto stored = read_stored_picture(path);
    if (!stored) return bad_file(stored.error());
    const std::vector<int> from = layer.empty() ? color_channels(stored->picture) : layer_channels(stored->picture, layer);
    if (from.empty()) {
        const std::string has = fmt::format("{}", fmt::join(stored->picture.names, ", "));
        if (!layer.empty()) return bad_file(fmt::format("{} has no layer '{}': its channels are {}", path, layer, has));
        return bad_file(fmt::format("{} has no channels R, G, B or Y: --layer names one of its layers; its channels are {}", path, has));
    }
    if (!layer.empty() && !is_comparable(stored->picture, from))
        return bad_file(fmt::format("{}: the layer '{}' has {} channels, which are no colours: --layer {} compares one of them", path, layer, from.size(),
                                    stored->picture.names[size_t(from[0])]));
    std::vector<std::string> names{"R", "G", "B", "A"};
    if (from.size() == 1 || is_gray_with_alpha(stored->picture, from)) names = {"Y", "A"};
    names.resize(from.size());
    Picture picture = select_channels(stored->picture, from, names);
    return Side{std::move(picture), stored->levels, stored->gamma, stored->levels == 0, stored->picture.names.size() - from.size(), std::move(stored->left_out)};
}

void drop_last_channel(Picture& picture) {
    std::vector<int> from;
    for (int c = 0; c + 1 < picture.channels; ++c) from.push_back(c);
    std::vector<std::string> names(picture.names.begin(), picture.names.end() - 1);
    picture = select_channels(picture, from, std::move(names));
}

/// Which pixels are compared: 1 or 0.
using Counts = std::vector<uint8_t>;

/// But for alphas that are no numbers.
bool is_opaque(const Picture& picture, const Counts& counts) {
    const size_t channels = size_t(picture.channels);
    for (size_t p = 0; p < counts.size(); ++p) {
        const float alpha = picture.values[(p + 1) * channels - 1];
        if (counts[p] && alpha != 1 && std::isfinite(alpha)) return false;
    }
    return true;
}

/// An alpha that is no number is not lost: the colours become it.
void drop_alpha(Picture& picture) {
    for (auto pixel = picture.values.begin(); pixel != picture.values.end(); pixel += picture.channels)
        if (const float alpha = pixel[picture.channels - 1]; !std::isfinite(alpha)) std::fill_n(pixel, picture.channels, alpha);
    drop_last_channel(picture);
}

/// But for pixels that are not finite.
bool is_gray(const Picture& picture, const Counts& counts) {
    const size_t channels = size_t(picture.channels);
    for (size_t p = 0; p < counts.size(); ++p) {
        const float* pixel = &picture.values[p * channels];
        if (counts[p] && (pixel[0] != pixel[1] || pixel[0] != pixel[2]) && std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2])) return false;
    }
    return true;
}

/// One channel of three; where one of these is not finite, that one.
void make_gray(Picture& picture) {
    for (auto pixel = picture.values.begin(); pixel != picture.values.end(); pixel += picture.channels)
        for (int c = 1; c < 3 && std::isfinite(*pixel); ++c)
            if (!std::isfinite(pixel[c])) *pixel = pixel[c];
    picture = picture.channels == 4 ? select_channels(picture, {0, 3}, {"Y", "A"}) : select_channels(picture, {0}, {"Y"});
}

tl::expected<void, NoPair> match_alpha(Side& reference, Side& test, const Counts& counts, const std::string (&paths)[2], std::vector<std::string>& notes) {
    for (Side* side : {&reference, &test})
        if (has_alpha(side->picture) && is_opaque(side->picture, counts)) drop_alpha(side->picture);
    const bool has[2] = {has_alpha(reference.picture), has_alpha(test.picture)};
    if (has[0] != has[1])
        return incomparable("alpha", fmt::format("{} is transparent in places, {} has no alpha", paths[has[0] ? 0 : 1], paths[has[0] ? 1 : 0]));
    if (has[0]) notes.push_back("colours are compared premultiplied by alpha, and alpha as one channel more");
    return {};
}

tl::expected<void, NoPair> match_colors(Side& reference, Side& test, const Counts& counts, const std::string (&paths)[2], std::vector<std::string>& notes) {
    const auto colors = [](const Side& side) { return side.picture.channels - has_alpha(side.picture); };
    const int count[2] = {colors(reference), colors(test)};
    if (count[0] == count[1]) return {};
    if (count[0] == 2 || count[1] == 2) return incomparable("channels", fmt::format("{} has {} channels, {} has {}", paths[0], count[0], paths[1], count[1]));
    const bool gray[2] = {count[0] == 1, count[1] == 1};
    Picture& colored = gray[0] ? test.picture : reference.picture;
    if (!is_gray(colored, counts)) return incomparable("channels", fmt::format("{} is gray, {} has colours", paths[gray[0] ? 0 : 1], paths[gray[0] ? 1 : 0]));
    notes.push_back(fmt::format("{} is gray in each pixel: one channel is compared", paths[gray[0] ? 1 : 0]));
    make_gray(colored);
    return {};
}

/// Calls change(value) for each value that is not alpha.
template <class Change>
void for_each_color(Picture& picture, Change&& change) {
    const size_t channels = size_t(picture.channels), colors = channels - has_alpha(picture);
    for (size_t i = 0; i < picture.values.size(); ++i)
        if (i % channels < colors) picture.values[i] = change(picture.values[i]);
}

/// Multiplies colour by alpha, or divides it where `by` is -1 (where alpha is 0, colour stays).
void premultiply(Picture& picture, int by) {
    if (!has_alpha(picture)) return;
    const size_t channels = size_t(picture.channels);
    for (size_t p = 0; p < picture.values.size(); p += channels) {
        const float alpha = picture.values[p + channels - 1];
        for (size_t c = 0; c + 1 < channels; ++c)
            if (by > 0) picture.values[p + c] *= alpha;
            else if (alpha != 0 && alpha != 1) picture.values[p + c] /= alpha;
    }
}

float encoded(double linear) { return std::isfinite(linear) ? float(linear_to_srgb(std::clamp(linear, 0.0, 1.0))) : float(linear); }

/// Straight display values. Files of floats hold premultiplied linear ones.
void to_display(Side& side) {
    if (side.levels == 0) {
        premultiply(side.picture, -1);
        for_each_color(side.picture, [](float value) { return encoded(value); });
    } else if (side.gamma > 0 && std::abs(side.gamma - 1 / 2.2) > 0.01) {
        for_each_color(side.picture, [&](float value) { return encoded(std::pow(double(value), 1 / side.gamma)); });
    }
}

/// Rounds to k / levels.
void round_to(Picture& picture, uint32_t levels) {
    for (float& value : picture.values)
        if (std::isfinite(value)) value = float(std::round(double(value) * levels) / levels);
}

void match_values(Side& reference, Side& test, std::vector<std::string>& notes) {
    to_display(reference), to_display(test);
    const uint32_t coarser = std::min(reference.levels ? reference.levels : UINT32_MAX, test.levels ? test.levels : UINT32_MAX);
    if (reference.levels != test.levels) {
        notes.push_back(fmt::format("the {} has finer values than the {}: they are rounded to steps of 1/{}", reference.levels == coarser ? "test" : "reference",
                                    reference.levels == coarser ? "reference" : "test", coarser));
        round_to(reference.levels == coarser ? test.picture : reference.picture, coarser);
    }
    premultiply(reference.picture, 1), premultiply(test.picture, 1);
}

bool same_value(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// What a pixel's values that are not finite are.
struct Odd {
    bool any = false, differ = false, nan = false, in_test = false;
};

Odd odd_values(const PicturePair& pair, size_t pixel) {
    Odd odd;
    const size_t channels = size_t(pair.reference.channels);
    for (size_t i = pixel * channels; i < (pixel + 1) * channels; ++i) {
        const float a = pair.reference.values[i], b = pair.test.values[i];
        if (std::isfinite(a) && std::isfinite(b)) continue;
        odd.any = true, odd.nan = odd.nan || std::isnan(a) || std::isnan(b);
        if (same_value(a, b)) continue;
        odd.differ = true;
        odd.in_test = odd.in_test || (odd.nan ? std::isnan(b) : !std::isfinite(b));   // NaN against an infinity: the NaN is the one to tell of
    }
    return odd;
}

/// Takes pixels that are not finite out of the count, tells of them, and marks those that differ in `differ`.
NonFinite take_out_non_finite(PicturePair& pair, std::vector<uint8_t>& differ) {
    NonFinite found;
    differ.assign(pair.pixels(), 0);
    for (size_t p = 0; p < pair.pixels(); ++p) {
        const Odd odd = pair.counts[p] ? odd_values(pair, p) : Odd();
        if (!odd.any) continue;
        pair.counts[p] = 0, differ[p] = odd.differ;
        size_t& kind = odd.differ ? found.in_one : odd.nan ? found.nan_in_both : found.inf_in_both;
        const bool first = ++kind == 1 && (odd.differ || (odd.nan && found.in_one == 0));
        if (!first) continue;
        found.nan = odd.nan, found.in_test = odd.in_test;
        found.x = int(p % size_t(pair.width())), found.y = int(p / size_t(pair.width()));
    }
    if (found.in_one == 0) differ.clear();
    return found;
}

/// Pixels that do not count hold 0, so that what looks around a pixel meets a number.
void clear_uncounted(PicturePair& pair) {
    const size_t channels = size_t(pair.reference.channels);
    for (size_t i = 0; i < pair.reference.values.size(); ++i)
        if (!pair.counts[i / channels]) pair.reference.values[i] = pair.test.values[i] = 0;
}

Picture crop(const Picture& picture, int x0, int y0, int x1, int y1) {
    Picture out(x1 - x0, y1 - y0, picture.names);
    for (int y = y0; y < y1; ++y) std::copy_n(picture.at(x0, y), size_t(out.width) * size_t(out.channels), out.at(0, y - y0));
    return out;
}

tl::expected<void, NoPair> crop_both(Picture& reference, Picture& test, const PairOptions& options) {
    if (!options.x0) return {};
    if (*options.x1 > reference.width || *options.y1 > reference.height)
        return bad_file(fmt::format("--crop {},{},{},{} is not inside the picture, which has {} x {} pixels", *options.x0, *options.y0, *options.x1, *options.y1,
                                    reference.width, reference.height));
    reference = crop(reference, *options.x0, *options.y0, *options.x1, *options.y1);
    test = crop(test, *options.x0, *options.y0, *options.x1, *options.y1);
    return {};
}

/// The mask has the size of the files, or of the part that is compared.
tl::expected<Counts, NoPair> read_counts(const PairOptions& options, const Picture& whole, const Picture& part) {
    Counts counts(size_t(part.width) * size_t(part.height), 1);
    if (options.mask.empty()) return counts;
    auto side = read_side(options.mask, "");
    if (!side) return tl::unexpected(side.error());
    Picture& mask = side->picture;
    if (options.x0 && mask.width == whole.width && mask.height == whole.height) mask = crop(mask, *options.x0, *options.y0, *options.x1, *options.y1);
    if (mask.width != part.width || mask.height != part.height)
        return incomparable("mask", fmt::format("the mask {} has {} x {} pixels, the pictures {} x {}", options.mask, mask.width, mask.height, whole.width, whole.height));
    for (size_t p = 0; p < counts.size(); ++p) counts[p] = mask.values[p * size_t(mask.channels)] > 0.5F;
    if (std::none_of(counts.begin(), counts.end(), [](uint8_t c) { return c != 0; }))
        return incomparable("mask", fmt::format("the mask {} leaves no pixel to compare", options.mask));
    return counts;
}

bool same_bytes(const std::string& a, const std::string& b) {
    const auto first = read_file(a), second = read_file(b);
    return first && second && *first == *second;
}

}  // namespace

tl::expected<LoadedPair, NoPair> load_pair(const std::string& reference_path, const std::string& test_path, const PairOptions& options) {
    const std::string paths[2] = {reference_path, test_path};
    const auto other_size = [&](uint64_t width, uint64_t height, uint64_t test_width, uint64_t test_height) {
        return incomparable("size", fmt::format("{} has {} x {} pixels, {} has {} x {}", paths[0], width, height, paths[1], test_width, test_height));
    };
    const auto told = header_size(paths[0]), test_told = header_size(paths[1]);       // a large picture takes seconds
    if (told && test_told && *told != *test_told) return other_size(told->first, told->second, test_told->first, test_told->second);
    auto reference = read_side(paths[0], options.layer), test = read_side(paths[1], options.layer);
    if (!reference) return tl::unexpected(reference.error());
    if (!test) return tl::unexpected(test.error());
    const Picture &a = reference->picture, &b = test->picture;
    if (a.width != b.width || a.height != b.height) return other_size(uint64_t(a.width), uint64_t(a.height), uint64_t(b.width), uint64_t(b.height));

    LoadedPair out;
    out.same_files = same_bytes(paths[0], paths[1]);
    if (options.layer.empty() && reference->others + test->others > 0)
        out.notes.push_back(fmt::format("only colours are compared: {} other channels are not (--layer names one)", std::max(reference->others, test->others)));
    for (const auto& [side, path] : {std::pair{&*reference, &paths[0]}, {&*test, &paths[1]}})
        for (const std::string& clause : side->left_out) out.notes.push_back(fmt::format("not compared of {}: {}", *path, clause));
    const Picture whole(a.width, a.height, {});
    if (auto fits = crop_both(reference->picture, test->picture, options); !fits) return tl::unexpected(fits.error());
    auto counts = read_counts(options, whole, reference->picture);
    if (!counts) return tl::unexpected(counts.error());
    if (auto fits = match_alpha(*reference, *test, *counts, paths, out.notes); !fits) return tl::unexpected(fits.error());
    if (auto fits = match_colors(*reference, *test, *counts, paths, out.notes); !fits) return tl::unexpected(fits.error());
    out.pair.hdr = reference->levels == 0 && test->levels == 0;
    out.fine = !out.pair.hdr && std::min(reference->levels - 1, test->levels - 1) >= 256;   // 0, for floats, is the most
    if (!out.pair.hdr) match_values(*reference, *test, out.notes);
    out.pair.reference = std::move(reference->picture), out.pair.test = std::move(test->picture);
    out.pair.counts = std::move(*counts), out.pair.threads = options.threads;
    out.non_finite = take_out_non_finite(out.pair, out.odd);
    if (!out.odd.empty()) out.shown[0] = out.pair.reference, out.shown[1] = out.pair.test;
    if (out.non_finite.inf_in_both > 0) out.notes.push_back(fmt::format("{} pixels are infinite in both pictures: they are equal", out.non_finite.inf_in_both));
    clear_uncounted(out.pair);
    return out;
}

}  // namespace alidade

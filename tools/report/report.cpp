// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.h"

#include "tools/metrics/metric.h"
#include "tools/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>

namespace alidade {

std::string base64(std::span<const std::byte> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t j = 0; j < 3; ++j) group = group << 8 | (i + j < bytes.size() ? std::to_integer<uint32_t>(bytes[i + j]) : 0u);
        for (size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

namespace {

using Json = nlohmann::ordered_json;

/// Values 0 .. 1 as a picture whose file holds them, rounded to 1/255: the encoder's sRGB curve is taken off before.
Picture stored_as(int width, int height, std::vector<std::string> names, const std::function<double(size_t)>& value) {
    Picture picture(width, height, std::move(names));
    for (size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = float(srgb_to_linear(value(i)));
    return picture;
}

Picture of_objects(const ReportPair& pair) {
    const auto& objects = *pair.objects;
    return stored_as(pair.reference.width, pair.reference.height, {"R", "G", "B"}, [&](size_t i) {
        const uint32_t index = std::min(objects.index[i / 3], (1u << 24) - 1);
        return double(index >> (16 - 8 * (i % 3)) & 255) / 255;
    });
}

/// The nearest IEEE half: sign, five bits of exponent, ten of mantissa.
uint32_t half_of(float value) {
    const auto bits = std::bit_cast<uint32_t>(value);
    const uint32_t sign = bits >> 16 & 0x8000u, size = bits & 0x7fffffffu;
    if (std::isnan(value)) return 0x7e00;
    if (std::bit_cast<float>(size) < 0x1p-14f) return sign | uint32_t(std::lround(std::bit_cast<float>(size) * 0x1p24f));
    const uint32_t rounded = size + 0xfff + (size >> 13 & 1);   // ties to even
    return sign | std::min((rounded - (112u << 23)) >> 13, 0x7c00u);
}

/// A byte of each value's half.
Picture of_halves(const Picture& linear, uint32_t shift) {
    return stored_as(linear.width, linear.height, linear.names, [&](size_t i) { return double(half_of(linear.values[i]) >> shift & 255) / 255; });
}

/// How many pixels have an error in each fiftieth of 0 .. 1.
Json histogram(const ReportPair& pair) {
    std::array<size_t, 50> bins{};
    for (size_t i = 0; i < pair.map.size(); ++i) {
        if (!pair.counts.empty() && !pair.counts[i]) continue;
        ++bins[std::min(size_t(std::max(pair.map[i], 0.0f) * float(bins.size())), bins.size() - 1)];
    }
    return bins;
}

size_t size_of(const Picture& picture) { return size_t(picture.width) * size_t(picture.height); }

/// Sizes that do not belong together, as a sentence.
std::string why_not_shown(const ReportPair& pair) {
    const size_t pixels = size_of(pair.reference);
    const bool fits = pair.test.width == pair.reference.width && pair.test.height == pair.reference.height && pair.map.size() == pixels &&
                      (pair.counts.empty() || pair.counts.size() == pixels) && (!pair.objects || pair.objects->index.size() == pixels);
    return fits ? "" : fmt::format("{}: pictures, error map and objects have different sizes", pair.name);
}

/// A picture as a block that scripts read: base64 text, which the page's parser passes over.
std::string block(size_t pair, const char* what, const std::string& text) {
    return fmt::format("<script type=\"text/plain\" id=\"{}-{}\">{}</script>\n", what, pair, text);
}

tl::expected<std::string, std::string> picture_blocks(const ReportPair& pair, size_t number) {
    std::string out;
    if (size_of(pair.reference) == 0) return out;
    if (const std::string why = why_not_shown(pair); !why.empty()) return tl::unexpected(why);
    std::vector<std::pair<const char*, Picture>> pictures = {{"reference", pair.reference}, {"test", pair.test}};
    pictures.emplace_back("error", stored_as(pair.reference.width, pair.reference.height, {"Y"}, [&](size_t i) { return std::clamp(double(pair.map[i]), 0.0, 1.0); }));
    if (pair.objects) pictures.emplace_back("objects", of_objects(pair));
    if (pair.linear) {
        for (const auto& [high, low, picture] : {std::tuple{"reference-high", "reference-low", &pair.reference}, {"test-high", "test-low", &pair.test}}) {
            pictures.emplace_back(high, of_halves(*picture, 8));
            pictures.emplace_back(low, of_halves(*picture, 0));
        }
    }
    for (const auto& [what, picture] : pictures) {
        const auto bytes = encode_picture(picture, ".png");
        if (!bytes) return tl::unexpected(fmt::format("{}: {}", pair.name, bytes.error()));
        out += block(number, what, base64(*bytes));
    }
    return out;
}

Json described(const ReportPair& pair) {
    Json out = {{"name", pair.name}, {"group", pair.group}, {"document", pair.document}, {"statistics", pair.statistics}, {"commands", pair.commands}};
    out["width"] = pair.reference.width, out["height"] = pair.reference.height;
    if (!pair.map.empty()) out["histogram"] = histogram(pair);
    if (pair.objects) out["objects"] = pair.objects->names;
    return out;
}

/// Of two pairs of one verdict the one with the larger error is worse.
std::pair<int, double> badness(const ReportPair& pair) {
    const Json flip = pair.document.value("/metrics/flip/mean"_json_pointer, Json());
    return {pair.document.value("exit_code", 0), flip.is_number() ? flip.get<double>() : 0.0};
}

std::vector<const ReportPair*> worst_first(const Report& report) {
    std::vector<const ReportPair*> order;
    for (const ReportPair& pair : report.pairs) order.push_back(&pair);
    std::stable_sort(order.begin(), order.end(), [](const ReportPair* a, const ReportPair* b) { return badness(*a) > badness(*b); });
    return order;
}

Json metric_table() {
    Json table = Json::array();
    for (const Metric& metric : metrics()) table.push_back({{"name", metric.name}, {"unit", metric.unit}, {"doc", metric.doc}});
    return table;
}

}  // namespace

tl::expected<std::string, std::string> report_html(const Report& report) {
    Json data = {{"title", report.title}, {"versions", report.versions}, {"metrics", metric_table()}, {"pairs", Json::array()}};
    std::string pictures;
    for (const ReportPair* pair : worst_first(report)) {
        auto blocks = picture_blocks(*pair, data["pairs"].size());
        if (!blocks) return tl::unexpected(std::move(blocks.error()));
        pictures += *blocks;
        data["pairs"].push_back(described(*pair));
    }
    return page_html(report.title, kReportCss, data, kReportJs, pictures);
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        const bool plain = !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%") == word.npos;
        if (!line.empty()) line += ' ';
        if (plain) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

}  // namespace alidade

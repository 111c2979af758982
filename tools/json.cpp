// SPDX-License-Identifier: Apache-2.0
#include "tools/json.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace alidade {

namespace {

std::string cell(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
    if (value.is_null()) return "-";
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (!value.is_array() && !value.is_object()) return value.dump();
    std::string out;
    for (const auto& [key, each] : value.items()) out += (out.empty() ? "" : value.is_object() ? ", " : " ") + (value.is_object() ? key + " " : "") + cell(each);
    return out;
}

/// Length on screen of UTF-8 text, one column a code point.
size_t columns(const std::string& text) {
    return size_t(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, size_t width, bool to_the_right) {
    const std::string space(width - std::min(width, columns(text)), ' ');
    return to_the_right ? space + text : text + space;
}

/// The keys of the first row head the columns; the rows have the same keys.
std::string table(const Json& rows) {
    std::string out;
    std::vector<std::string> keys;
    std::vector<size_t> widths;
    for (const auto& [key, value] : rows[0].items()) {
        size_t width = columns(key);
        for (const Json& row : rows) width = std::max(width, columns(cell(row.at(key))));
        keys.push_back(key), widths.push_back(width);
    }
    const auto line = [&](const auto& text_of, const auto& right) {
        std::string text = " ";
        for (size_t i = 0; i < keys.size(); ++i) text += " " + padded(text_of(keys[i]), widths[i], right(keys[i])) + (i + 1 < keys.size() ? " " : "");
        text.erase(text.find_last_not_of(' ') + 1);
        return text + "\n";
    };
    const auto number = [&](const std::string& key) { return rows[0].at(key).is_number(); };
    out += line([](const std::string& key) { return key; }, number);
    for (const Json& row : rows) out += line([&](const std::string& key) { return cell(row.at(key)); }, number);
    return out;
}

}  // namespace

Json to_json(const BuildStats& s) {
    return {{"seconds", s.seconds}, {"primitives", s.primitives}, {"references", s.references}, {"nodes", s.nodes}, {"leaves", s.leaves},
            {"depth", s.depth}, {"bytes", s.bytes}, {"sah_cost", s.sah_cost}, {"spatial splits", s.splits}, {"split candidates", s.split_candidates}, {"removed", s.removed.size()}};
}

Json to_json(const CompiledSummary& s) {
    return {{"instances", s.instances}, {"geometries", s.geometries}, {"lights", s.lights}, {"images", s.images}, {"triangles", s.triangles},
            {"instanced_triangles", s.instanced_triangles}, {"structures_waiting", s.waiting}, {"bytes", s.bytes}, {"accelerator", s.accelerator}, {"intersect", s.intersect}};
}

Json to_json(const RenderStats& s) {
    const double per_pixel = s.pixels ? double(s.camera_rays) / double(s.pixels) : 0;
    return {{"pixels", s.pixels}, {"pixels_ended_early", s.pixels_ended_early}, {"samples_per_pixel", per_pixel},
            {"camera_rays", s.camera_rays}, {"shadow_rays", s.shadow_rays}, {"secondary_rays", s.secondary_rays},
            {"accelerator_rays", s.work.rays}, {"boxes", s.work.boxes}, {"filtered", s.work.filtered}, {"primitives", s.work.primitives},
            {"exact", s.work.exact}, {"texture_reads", s.texture_reads}, {"seconds", s.seconds}, {"cpu_seconds", s.cpu_seconds}, {"tiles", s.tiles}, {"tiles_done", s.tiles_done}};
}

Json to_json(const Diagnostics& diagnostics) {
    static constexpr const char* kSeverity[] = {"note", "warning", "error"};
    Json list = Json::array();
    for (const Diagnostic& d : diagnostics.list())
        list.push_back({{"severity", kSeverity[int(d.severity)]}, {"where", diagnostics.where(d.at)}, {"message", d.message}, {"hint", d.hint}});
    return list;
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

std::string processor() {
    std::ifstream lines("/proc/cpuinfo");
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("model name") && line.find(": ") != line.npos) return line.substr(line.find(": ") + 2);
    return "unknown";
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == text.npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string as_text(const Json& object) {
    const auto is_table = [](const Json& value) { return value.is_array() && !value.empty() && value[0].is_object(); };
    std::string lines, tables;
    size_t width = 0;
    for (const auto& [key, value] : object.items())
        if (!is_table(value)) width = std::max(width, key.size());
    for (const auto& [key, value] : object.items()) {
        if (is_table(value)) tables += fmt::format("\n{}:\n{}", key, table(value));
        else lines += fmt::format("{:<{}} {}\n", key + ":", width + 1, value.is_array() && value.empty() ? "none" : cell(value));
    }
    return lines.empty() && !tables.empty() ? tables.substr(1) : lines + tables;
}

std::string as_json_text(const Json& document) { return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace alidade

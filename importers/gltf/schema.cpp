// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/schema.h"

#include "importers/gltf/extensions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace alidade::gltf {

namespace {

/// Whole numbers up to here are exact in a double, and sums and products of a few of them with element sizes do not overflow 64 bits.
constexpr double kMaxInteger = 9007199254740992.0;   // 2^53

std::string describe(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array";
    if (value.is_string()) return "a string";
    if (value.is_boolean()) return "a boolean";
    if (value.is_null()) return "null";
    if (!value.is_number_float()) return "a number";
    return std::abs(value.get<double>()) > kMaxInteger ? value.dump() + ", which is beyond 2^53" : "a number with a fraction";
}

class Checker {
  public:
    Checker(const Json& root, Reporter& report) : root_(root), report_(report) {}

    /// `value` must be an object with `fields`. Members that no field names are removed.
    void check_object(Json& value, std::span<const Field> fields, const std::string& at) {
        if (!value.is_object()) return wrong_type(value, "an object", at);
        for (const Field& field : fields) {
            const auto it = value.find(field.name);
            if (it != value.end()) check_value(*it, field, child(at, field.name));
            else if (field.required) report_.error(at, fmt::format("property \"{}\" is missing", field.name));
        }
        const bool extensions = at.size() >= 11 && at.compare(at.size() - 11, 11, "/extensions") == 0;
        for (auto it = value.begin(); it != value.end();) {
            const bool known = std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return it.key() == f.name; });
            if (!known && extensions) report_.extension_ignored(child(at, it.key()), it.key());
            if (!known && it.key() == "extensions") check_foreign_extensions(*it, at);
            it = known ? std::next(it) : value.erase(it);
        }
    }

  private:
    void wrong_type(const Json& value, const char* wanted, const std::string& at) {
        report_.error(at, fmt::format("must be {}, not {}", wanted, describe(value)));
    }

    /// Extensions at a place where none is supported.
    void check_foreign_extensions(const Json& value, const std::string& at) {
        if (!value.is_object()) return wrong_type(value, "an object", child(at, "extensions"));
        for (auto it = value.begin(); it != value.end(); ++it) report_.extension_ignored(child(child(at, "extensions"), it.key()), it.key());
    }

    void check_value(Json& value, const Field& field, const std::string& at) {
        switch (field.kind) {
            case Kind::boolean:
                if (!value.is_boolean()) wrong_type(value, "a boolean", at);
                return;
            case Kind::integer: return check_integer(value, field, at);
            case Kind::number: return check_number(value, field, at);
            case Kind::text: return check_text(value, field, at);
            case Kind::index: return check_index(value, field, at);
            case Kind::index_map: return check_index_map(value, field, at);
            case Kind::integer_map: return check_integer_map(value, field, at);
            case Kind::object: return check_object(value, field.fields, at);
            case Kind::indices: check_array(value, field, at); return check_unique(value, at);
            default: return check_array(value, field, at);
        }
    }

    void check_array(Json& value, const Field& field, const std::string& at) {
        if (!value.is_array()) return wrong_type(value, "an array", at);
        if (value.size() < field.fewest || value.size() > field.most) {
            const std::string wanted = field.fewest == field.most ? fmt::format("{}", field.fewest)
                                       : value.size() < field.fewest ? fmt::format("at least {}", field.fewest)
                                                                     : fmt::format("at most {}", field.most);
            return report_.error(at, fmt::format("has {} elements, but needs {}", value.size(), wanted));
        }
        for (size_t i = 0; i < value.size(); ++i) check_element(value[i], field, at, i);
    }

    void check_element(Json& value, const Field& field, const std::string& at, size_t i) {
        switch (field.kind) {
            case Kind::numbers: return check_number_element(value, field, at, i);
            case Kind::texts: return check_text(value, field, child(at, i));
            case Kind::indices: return check_index(value, field, child(at, i));
            case Kind::index_maps: return check_index_map(value, field, child(at, i));
            default: return check_object(value, field.fields, child(at, i));
        }
    }

    /// Arrays of numbers are long: their pointers are only written out when something is wrong.
    void check_number_element(Json& value, const Field& field, const std::string& at, size_t i) {
        if (!value.is_number_float() || !in_range(value.get<double>(), field)) check_number(value, field, child(at, i));
    }

    /// Is `value` a whole number? If so, it is one afterwards in its type, too.
    static bool make_integer(Json& value) {
        if (value.is_number_integer()) return true;
        if (!value.is_number_float()) return false;
        const double number = value.get<double>();
        if (number != std::floor(number) || std::abs(number) > kMaxInteger) return false;
        value = int64_t(number);
        return true;
    }

    void check_integer(Json& value, const Field& field, const std::string& at) {
        if (!make_integer(value)) return wrong_type(value, "an integer", at);
        const double number = value.get<double>();
        if (!field.integers.empty()) {
            if (std::find(field.integers.begin(), field.integers.end(), number) == field.integers.end())
                report_.error(at, fmt::format("{} is not one of {}", value.dump(), fmt::join(field.integers, ", ")));
        } else if (!in_range(number, field) || number > kMaxInteger) {
            out_of_range(value, field, at);
        }
    }

    static bool in_range(double number, const Field& field) {
        return number <= field.max && (field.above_min ? number > field.min : number >= field.min);
    }

    void out_of_range(Json& value, const Field& field, const std::string& at) {
        const std::string lower = std::isfinite(field.min) ? fmt::format("{} {}", field.above_min ? "greater than" : "at least", field.min) : "";
        const bool beyond = !std::isfinite(field.max) && std::abs(value.get<double>()) > kMaxInteger && value.is_number_integer();
        const std::string upper = std::isfinite(field.max) || beyond ? fmt::format("{}at most {}", lower.empty() ? "" : " and ", beyond ? "2^53" : fmt::format("{}", field.max)) : "";
        const std::string limits = lower + upper;
        if (!field.clamped) return report_.error(at, fmt::format("{} must be {}", value.dump(), limits.empty() ? "at most 2^53" : limits));
        const double number = value.get<double>(), nearest = std::clamp(number, field.min, field.max);
        report_.warning(at, fmt::format("{} should be {}: {} is used", value.dump(), limits, nearest));
        value = nearest;
    }

    void check_number(Json& value, const Field& field, const std::string& at) {
        if (!value.is_number()) return wrong_type(value, "a number", at);
        if (!value.is_number_float()) value = value.get<double>();   // tinygltf keeps whole numbers of extensions in an int
        if (!in_range(value.get<double>(), field)) out_of_range(value, field, at);
    }

    void check_text(const Json& value, const Field& field, const std::string& at) {
        if (!value.is_string()) return wrong_type(value, "a string", at);
        const auto& text = value.get_ref<const std::string&>();
        if (!field.texts.empty() && std::find(field.texts.begin(), field.texts.end(), text) == field.texts.end())
            report_.error(at, fmt::format("\"{}\" is not one of {}", text.substr(0, 100), fmt::join(field.texts, ", ")));
    }

    void check_index(Json& value, const Field& field, const std::string& at) {
        if (!make_integer(value)) return wrong_type(value, "an index", at);
        const size_t count = elements(field.target);
        if (value.get<double>() < 0 || value.get<double>() >= double(count))
            report_.error(at, fmt::format("index {} is out of range: {} has {} elements", value.dump(), field.target, count));
    }

    void check_index_map(Json& value, const Field& field, const std::string& at) {
        if (!value.is_object()) return wrong_type(value, "an object", at);
        for (auto it = value.begin(); it != value.end(); ++it) check_index(*it, field, child(at, it.key()));
    }

    void check_integer_map(Json& value, const Field& field, const std::string& at) {
        if (!value.is_object()) return wrong_type(value, "an object", at);
        for (auto it = value.begin(); it != value.end(); ++it) check_integer(*it, field, child(at, it.key()));
    }

    void check_unique(const Json& value, const std::string& at) {
        if (!value.is_array()) return;
        std::set<int64_t> seen;
        for (size_t i = 0; i < value.size(); ++i)
            if (value[i].is_number_integer() && !seen.insert(value[i].get<int64_t>()).second)
                report_.error(child(at, i), fmt::format("{} is in the list twice", value[i].dump()));
    }

    /// How many elements the array at `pointer` has; 0 if it is not there.
    size_t elements(const char* pointer) {
        const auto [it, fresh] = elements_.try_emplace(pointer, 0);
        if (!fresh) return it->second;
        const Json::json_pointer where{pointer};
        if (root_.contains(where) && root_.at(where).is_array()) it->second = root_.at(where).size();
        return it->second;
    }

    const Json& root_;
    Reporter& report_;
    std::map<std::string_view, size_t> elements_;
};

}  // namespace

void check_schema(Json& root, Reporter& report) { Checker(root, report).check_object(root, root_fields(), ""); }

/// Has it what only glTF 1.0 has?
static bool is_old(const Json& root) {
    return root.contains("techniques") || root.contains("shaders") || (root.contains("meshes") && root["meshes"].is_object());
}

void check_version(const Json& root, Reporter& report) {
    const char* hint = "convert the file to glTF 2.0, for example with `gltf-pipeline -i old.gltf -o new.gltf`";
    const auto asset = root.find("asset");
    if (asset == root.end()) {
        return report.error("", "property \"asset\" is missing", is_old(root) ? hint : "is this a glTF file?");
    }
    if (!asset->is_object()) return report.error("/asset", fmt::format("must be an object, not {}", describe(*asset)));
    const auto version = asset->find("version");
    if (version != asset->end() && version->is_number() && version->get<double>() < 2)
        return report.error("/asset/version", fmt::format("glTF version {} is not supported, only 2.x is", version->dump()), hint);
    if (version == asset->end() || !version->is_string())
        return report.error("/asset", "property \"version\" is missing or not a string", is_old(root) ? hint : "");
    const auto& text = version->get_ref<const std::string&>();
    if (text.rfind("2.", 0) != 0) {
        return report.error("/asset/version", fmt::format("glTF version \"{}\" is not supported, only 2.x is", text.substr(0, 100)),
                            text.rfind("1.", 0) == 0 || text.rfind("0.", 0) == 0 ? hint : "");
    }
    const auto minimum = asset->find("minVersion");
    if (minimum != asset->end() && minimum->is_string() && minimum->get_ref<const std::string&>() != "2.0")
        report.error("/asset/minVersion",
                     fmt::format("the file needs glTF {}, only 2.0 is supported", minimum->get_ref<const std::string&>().substr(0, 100)));
}

void check_extensions(const Json& root, Reporter& report) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end()) return;
    const auto used = root.find("extensionsUsed");
    for (size_t i = 0; i < required->size(); ++i) {
        const auto& name = (*required)[i].get_ref<const std::string&>();
        const std::string at = child("/extensionsRequired", i);
        const Extension* known = find_extension(name);
        if (!known) report.error(at, fmt::format("the file requires the extension {}, which is unknown", name));
        else if (known->support == Support::needed)
            report.error(at, fmt::format("the file requires the extension {}, which is not supported", name), known->hint);
        else if (known->support == Support::ignored) report.extension_ignored(at, name);
        else if (used == root.end() || std::find(used->begin(), used->end(), name) == used->end())
            report.warning(at, fmt::format("extension {} is required, but not listed in extensionsUsed", name));
    }
}

}  // namespace alidade::gltf

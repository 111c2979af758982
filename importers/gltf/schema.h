// SPDX-License-Identifier: Apache-2.0
/// The shape of glTF 2.0's JSON as tables (glTF 2.0 specification, section 5 "Properties Reference"), and a checker that walks them.
#pragma once

#include "importers/gltf/json.h"
#include "importers/gltf/reporter.h"

#include <limits>
#include <span>

namespace alidade::gltf {

enum class Kind {
    boolean,
    integer,      ///< a number without fraction: 1.0 is one, and becomes 1
    number,
    text,
    index,        ///< into the array `target`
    index_map,    ///< an object of such indices: attributes
    integer_map,  ///< an object of integers
    object,       ///< with `fields`
    numbers,      ///< arrays of the above ...
    texts,
    indices,      ///< ... without a duplicate
    index_maps,
    objects,
};

/// One property of an object. Built by the functions below; what a table does not name is removed before anyone reads it.
struct Field {
    const char* name = "";
    Kind kind = Kind::object;
    bool required = false;
    bool clamped = false;                     ///< out of [min, max]: a warning, and the nearest bound is used
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
    bool above_min = false;                   ///< min itself is out of range
    std::span<const int> integers = {};           ///< the allowed values, if not empty
    std::span<const char* const> texts = {};      ///< the allowed values, if not empty
    const char* target = "";                  ///< pointer of the array that indices count in
    size_t fewest = 0, most = std::numeric_limits<size_t>::max();   ///< elements of an array
    std::span<const Field> fields = {};

    constexpr Field operator!() const {       ///< required
        Field f = *this;
        f.required = true;
        return f;
    }
};

/// The properties of a glTF file's root.
std::span<const Field> root_fields();

/// Checks `root` against the tables: types, required properties, ranges, allowed values, and that every index points into its array. What
/// passes holds only what the tables name, with whole numbers stored as integers; unknown extensions are reported, all else unknown is dropped.
void check_schema(Json& root, Reporter& report);

/// Is this a version that can be read? Asked first, since in other versions everything else looks different.
void check_version(const Json& root, Reporter& report);

/// What is in extensionsRequired must be known and supported. `root` has passed check_schema().
void check_extensions(const Json& root, Reporter& report);

}  // namespace alidade::gltf

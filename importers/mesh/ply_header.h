// SPDX-License-Identifier: Apache-2.0
/// The header of a PLY file: which elements follow, and how they are written.
#pragma once

#include "importers/mesh/reporter.h"

#include <optional>
#include <string>
#include <vector>

namespace alidade::mesh {

enum class PlyType : uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in a binary file.
size_t size_of(PlyType type);
bool is_integer(PlyType type);
/// Of an integer type: what stands for 1 where it holds a fraction.
double largest(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;                        ///< of the value, or of a list's items
    std::optional<PlyType> count_type;   ///< of lists only; an integer
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;                  ///< as claimed
    std::vector<PlyProperty> properties;
    TextCursor::Mark at;                 ///< its statement
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;    ///< in the order of their data; no two have the same name
};

/// Reads up to the line after end_header, in which the data begins; nothing if there are errors, which are reported at their places.
/// Source   Turk, "The PLY Polygon File Format", 1994; the type names with sizes (int32, float64) as rply and others write them.
std::optional<PlyHeader> read_ply_header(TextCursor& cursor, Reporter& report);

}  // namespace alidade::mesh

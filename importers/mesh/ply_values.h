// SPDX-License-Identifier: Apache-2.0
/// The data of a PLY file, value after value, however it is encoded.
#pragma once

#include "importers/mesh/ply_header.h"

#include <string_view>

namespace alidade::mesh {

/// Reads values in the file's order. In text, an element is a line of its own; blank lines are skipped. What returns false has reported why:
/// text at its line and column, binary data with the byte's number in the message.
class PlyValues {
  public:
    /// The cursor stands at the first byte of the data.
    PlyValues(std::string_view text, const TextCursor& cursor, PlyEncoding encoding, uint32_t file, Diagnostics& said);

    bool begin_element();
    /// Sets `out` to the next value.
    bool read(PlyType type, double& out);
    /// The length of a list; false if the file is too short for so many items.
    bool read_length(const PlyProperty& list, size_t& out);
    /// False, without a report, if the line has more values: they are skipped.
    bool end_element();

    /// Does the last value lose digits as a float?
    bool exceeds_float() const { return exceeds_float_; }
    /// Of the element; 0 in binary data.
    uint32_t line() const { return encoding_ == PlyEncoding::ascii ? last_.line : 0; }
    size_t bytes_left() const { return size_t(end_ - (encoding_ == PlyEncoding::ascii ? cursor_.mark().at : at_)); }
    /// The fewest bytes that an element can take; in text with the blank or the line end after each value, which the file's last may lack.
    size_t least_bytes(const PlyElement& element) const;
    /// Reports an error at the last value.
    bool fail(std::string message);
    /// Nothing but blanks is left.
    bool at_end();

  private:
    bool read_text(double& out);
    bool read_binary(PlyType type, double& out);
    template <class T> T take();

    PlyEncoding encoding_;
    TextCursor cursor_;        ///< in text
    Reporter report_;
    const char* begin_;
    const char* end_;
    const char* at_;           ///< in binary data
    TextCursor::Mark last_{};
    const char* last_byte_;
    uint32_t file_;
    bool exceeds_float_ = false;
};

}  // namespace alidade::mesh

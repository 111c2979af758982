// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace alidade::mesh {

PlyValues::PlyValues(std::string_view text, const TextCursor& cursor, PlyEncoding encoding, uint32_t file, Diagnostics& said)
    : encoding_(encoding), cursor_(cursor), report_(said, file, cursor_, false), begin_(text.data()), end_(text.data() + text.size()),
      at_(cursor.mark().at), last_(cursor.mark()), last_byte_(at_), file_(file) {
    // In a header whose lines end with CR alone, an LF after it is the data's first byte.
    const size_t line_end = text.find_first_of("\r\n");
    const bool cr_alone = text.substr(line_end, 1) == "\r" && text.substr(line_end + 1, 1) != "\n";
    if (cr_alone && at_[-1] == '\n') --at_;
}

bool PlyValues::fail(std::string message) {
    if (encoding_ == PlyEncoding::ascii) report_.error(last_, std::move(message));
    else report_.diagnostics().error({file_, 0, 0, {}}, fmt::format("byte {}: {}", last_byte_ - begin_, message));
    return false;
}

size_t PlyValues::least_bytes(const PlyElement& element) const {
    size_t bytes = 0;
    for (const PlyProperty& p : element.properties) bytes += encoding_ == PlyEncoding::ascii ? 2 : size_of(p.count_type.value_or(p.type));
    return bytes;
}

bool PlyValues::at_end() {
    if (encoding_ != PlyEncoding::ascii) return at_ == end_;
    while (!cursor_.at_end() && cursor_.at_line_end()) cursor_.next_line();
    return cursor_.at_end();
}

bool PlyValues::begin_element() {
    if (encoding_ != PlyEncoding::ascii) return true;
    const bool missing = at_end();
    last_ = cursor_.mark();
    return !missing || fail("the file ends before its last element");
}

bool PlyValues::end_element() {
    if (encoding_ != PlyEncoding::ascii) return true;
    const bool complete = cursor_.at_line_end();
    cursor_.next_line();
    return complete;
}

bool PlyValues::read_text(double& out) {
    const bool missing = cursor_.at_line_end();
    last_ = cursor_.mark();
    if (missing) return fail("the line ends before the last value of its element");
    const std::optional<Number> number = cursor_.number();
    if (!number) return fail(fmt::format("\"{}\" is not a number", cursor_.word_at(last_)));
    exceeds_float_ = number->exceeds_float;
    out = number->value;
    return true;
}

template <class T> T PlyValues::take() {
    std::array<char, sizeof(T)> bytes;
    std::copy_n(at_, sizeof(T), bytes.begin());
    at_ += sizeof(T);
    if ((encoding_ == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

bool PlyValues::read_binary(PlyType type, double& out) {
    last_byte_ = at_;
    if (size_t(end_ - at_) < size_of(type)) return fail("the file ends in an element");
    switch (type) {
    case PlyType::int8: out = take<int8_t>(); break;
    case PlyType::uint8: out = take<uint8_t>(); break;
    case PlyType::int16: out = take<int16_t>(); break;
    case PlyType::uint16: out = take<uint16_t>(); break;
    case PlyType::int32: out = take<int32_t>(); break;
    case PlyType::uint32: out = take<uint32_t>(); break;
    case PlyType::float32: out = double(take<float>()); break;
    case PlyType::float64: out = take<double>(); break;
    }
    exceeds_float_ = (type == PlyType::float64 || type == PlyType::int32 || type == PlyType::uint32) && std::isfinite(out) && std::abs(out) < 1e38 &&
                     double(float(out)) != out;
    return true;
}

bool PlyValues::read(PlyType type, double& out) { return encoding_ == PlyEncoding::ascii ? read_text(out) : read_binary(type, out); }

bool PlyValues::read_length(const PlyProperty& list, size_t& out) {
    double length = 0;
    if (!read(*list.count_type, length)) return false;
    if (!(length >= 0) || length != std::floor(length)) return fail(fmt::format("a list of {} items", length));
    const size_t most = encoding_ == PlyEncoding::ascii ? bytes_left() / 2 + 1 : bytes_left() / size_of(list.type);
    if (length > double(most)) return fail(fmt::format("a list of {} items: the file has bytes for {} at most", length, most));
    out = size_t(length);
    return true;
}

}  // namespace alidade::mesh

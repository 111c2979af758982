// SPDX-License-Identifier: Apache-2.0
/// What verbs tell: built once as JSON (keys in the order of writing), printed as JSON or as text for people.
#pragma once

#include "core/diagnostics.h"
#include "tracer/render.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

using Json = nlohmann::ordered_json;

Json to_json(const BuildStats& stats);
Json to_json(const CompiledSummary& summary);
Json to_json(const RenderStats& stats);
/// An array of {severity, where, message, hint}.
Json to_json(const Diagnostics& diagnostics);

/// JSON has no infinities and no NaN: they are null.
Json number_or_null(double value);

/// The processor's own name; "unknown" where the machine does not say.
std::string processor();

/// The text of a cell of a CSV file, as RFC 4180 quotes it.
std::string csv_cell(const std::string& text);

/// An object as lines "key: value"; then each array of objects as a table below its key, a column for each of their keys, numbers to the right.
std::string as_text(const Json& object);

/// The document as a program reads it: indented, UTF-8 (what is not becomes U+FFFD), and a newline at the end.
std::string as_json_text(const Json& document);

}  // namespace alidade

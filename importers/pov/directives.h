// SPDX-License-Identifier: Apache-2.0
/// Directives: what begins with #. They stand between any two tokens, and are obeyed before the next token is given out.
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// Obeys the directive that has just been taken from the stream.
void obey(Parser& p, const Token& directive);

// ---- one file each ----
void obey_declaration(Parser& p, const Token& directive);    ///< #declare #local #undef #default #version
void obey_file_directive(Parser& p, const Token& directive); ///< #fopen #fclose #read #write
/// #if #ifdef #ifndef #else #elseif #end #while #for #switch #case #range #break; `index`: of the directive in its frame.
void obey_control(Parser& p, const Token& directive, uint32_t index);

}  // namespace alidade::pov

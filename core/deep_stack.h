// SPDX-License-Identifier: Apache-2.0
/// Room for functions that call themselves as deep as a file nests its parts.
#pragma once

#include <functional>

namespace alidade {

/// Calls `f` on a thread of its own whose call stack holds 256 MiB (memory is taken as it is used), and waits. Exceptions of `f` are thrown here. Where no
/// such thread can be had, `f` is called on this one.
void run_on_deep_stack(const std::function<void()>& f);

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Loops over threads. What is computed never depends on how many there are.
#pragma once

#include <cstddef>
#include <functional>

namespace alidade {

/// Calls body(i) once for every i < count, on at most `threads` threads (0: as many as the machine has), in no promised order. With one
/// thread the loop is a plain one, in order. An exception of `body` ends the loop and is thrown again here.
void parallel_for(size_t count, int threads, const std::function<void(size_t)>& body);

/// What `threads` = 0 means on this machine.
int hardware_threads();

}  // namespace alidade

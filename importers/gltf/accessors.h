// SPDX-License-Identifier: Apache-2.0
/// The numbers that accessors hold: every component type, normalised or not, strided, sparse, matrices with padded columns.
#pragma once

#include "importers/gltf/model.h"

namespace alidade::gltf {

/// A loaded model whose accessors have passed check_ranges().
using Model = tinygltf::Model;

/// How many components an element of `accessor` has.
uint32_t component_count(const tinygltf::Accessor& accessor);

/// All components of the elements `which` (increasing; empty: of all) as floats, element by element; normalised integers become [0, 1] or [-1, 1].
std::vector<float> read_floats(const Model& model, int accessor, std::span<const uint32_t> which = {});

/// The same of an accessor of unsigned integers.
std::vector<uint32_t> read_integers(const Model& model, int accessor, std::span<const uint32_t> which = {});

/// How many component values may be read from a model: a file may use its bytes several times over, but not thousands of times (a kilobyte of JSON
/// could otherwise ask for hours of work and for more memory than there is).
class ReadBudget {
  public:
    explicit ReadBudget(const Model& model);
    /// Takes `components` from the budget; false, and an error, if that much is not left.
    bool spend(uint64_t components, const std::string& at, Reporter& report);

  private:
    uint64_t left_ = 0;
};

/// What no reader may trust in the data themselves: floats must be finite, sparse indices increasing and inside.
void check_accessor_data(const Model& model, Reporter& report);

}  // namespace alidade::gltf

// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/function_values.h"

#include "importers/pov/builders/functions.h"
#include "importers/pov/builders/transforms.h"
#include "importers/pov/space_functions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

SpaceFunctions& space_functions(Parser& p) {
    if (!p.functions) p.functions = std::make_unique<SpaceFunctions>(p);
    return *p.functions;
}

}  // namespace

std::optional<std::array<double, 5>> function_colour(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    const Block* block = block_of(function);
    if (!block || block->word != "pigment"_w) return std::nullopt;
    if (arguments.size() != 3) p.fail(at, fmt::format("the function takes 3 arguments, and {} are given", arguments.size()));
    return space_functions(p).pigment(*block, {arguments[0], arguments[1], arguments[2]});
}

std::optional<Vec3> function_point(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    const Block* block = block_of(function);
    if (!block || block->word != "transform"_w) return std::nullopt;
    if (arguments.size() != 3) p.fail(at, "the function of a transformation takes three arguments");
    return build_transform(p, *block).point({arguments[0], arguments[1], arguments[2]});
}

double function_value(Parser& p, const Function& function, std::span<const double> arguments, Place at) { return space_functions(p).number(function, arguments, at); }

}  // namespace alidade::pov

// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/cycles_reference.h"
#include "tools/compare/povray_reference.h"

#include <fmt/format.h>

namespace alidade {
namespace {

tl::expected<Rendered, RenderFailure> povray_picture(const CompareJob& job, const CompiledScene&, const std::string& scratch) { return povray_reference(job, scratch); }

constexpr ReferenceProgram kTable[] = {
    {"povray", "POV-Ray", "one sample at the centre of each pixel", "povray (and povray-includes)", "scene.pov", ".png", 1, false, povray_version, povray_picture},
    {"cycles", "Cycles (Blender)", "16 samples a pixel", "blender", "scene.glb", ".exr", 16, true, blender_version, cycles_reference},
};

}  // namespace

std::span<const ReferenceProgram> references() { return kTable; }

std::string why_missing(const ReferenceProgram& program) {
    if (!program.version().empty()) return {};
    return fmt::format("{} is not installed: its package is {}", program.title, program.packages);
}

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Small picture files of all kinds that scenes of the tests show.
#pragma once

#include <filesystem>

namespace alidade::test {

/// 8 bits a colour unless told otherwise: plain.png, srgb.png and gamma.png (which say so), grey.png, alpha.png, palette.png (three colours, one half transparent),
/// deep.png and deep_grey.png (16 bits), smooth.png (grey, 16 bits, for reliefs), plain.ppm.
void write_sample_pictures(const std::filesystem::path& folder);

}  // namespace alidade::test

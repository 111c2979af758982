// SPDX-License-Identifier: Apache-2.0
/// Two files -> a pair that metrics can measure, or why there is none.
#pragma once

#include "tools/metrics/metric.h"

#include <optional>
#include <tl/expected.hpp>

namespace alidade {

struct PairOptions {
    std::string mask;                                             ///< a picture of the same size: pixels brighter than the half count; "" for all
    std::optional<int> x0, y0, x1, y1;                            ///< of the part that is compared, the ends outside
    std::string layer;                                            ///< channels "layer.X" are compared instead of the colours
    int threads = 0;
};

/// Pixels with a value that is NaN or infinite.
struct NonFinite {
    size_t in_one = 0;         ///< where the other picture has another value
    size_t nan_in_both = 0;    ///< NaN in both: both are broken there
    size_t inf_in_both = 0;    ///< the same infinity in both, as the depth of a background is
    bool nan = false;          ///< of the first in_one: it is a NaN (else an infinity)
    bool in_test = false;      ///< and the test's
    int x = 0, y = 0;          ///< of the first in_one, else of the first nan_in_both
};

struct LoadedPair {
    PicturePair pair;
    bool fine = false;                ///< display values of more than 8 bits
    NonFinite non_finite;
    std::vector<uint8_t> odd;         ///< one a pixel: 1 where one picture has a NaN or an infinity that the other has not; empty for none
    Picture shown[2];                 ///< reference and test with their NaN and infinities, where there are any; else empty
    std::vector<std::string> notes;   ///< what was done to make them comparable, a sentence each
    bool same_files = false;          ///< byte for byte
};

struct NoPair {
    bool incomparable = false;   ///< both files are pictures, but not of one size or kind
    std::string cause;           ///< one word for programs: "size", "channels", "alpha", "mask"; "file" where it is not incomparable
    std::string sentence;
};

/// Reads both files and makes them comparable:
///   values   If both hold floats they are linear and stay as they are. Else both become display values: integers are k / levels, sRGB-encoded unless a
///            PNG's gAMA chunk says otherwise; floats are clipped to 0 .. 1 and sRGB-encoded. Where the files differ in depth the finer is rounded to the
///            steps of the coarser.
///   alpha    Colour is premultiplied. An alpha that is 1 everywhere is as good as none; else both must have one.
///   gray     Colour that is gray everywhere is as good as gray; else both must have the same channels.
tl::expected<LoadedPair, NoPair> load_pair(const std::string& reference, const std::string& test, const PairOptions& options);

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/grade.h"

#include "tools/metrics/differences.h"

namespace alidade {
namespace {

PicturePair colors_alone(const PicturePair& pair) {
    PicturePair out;
    out.counts = pair.counts, out.threads = pair.threads;
    for (const auto& [from, to] : {std::pair(&pair.reference, &out.reference), std::pair(&pair.test, &out.test)}) {
        *to = Picture(pair.width(), pair.height(), {"R", "G", "B"});
        to->values = display_colors(pair, *from);
    }
    return out;
}

/// The means of 4 x 4 pixels; what is left over at the right and at the bottom is left out.
Picture reduced(const Picture& picture) {
    constexpr int kSide = 4;
    Picture out(picture.width / kSide, picture.height / kSide, picture.names);
    for (int y = 0; y < out.height * kSide; ++y)
        for (int x = 0; x < out.width * kSide; ++x)
            for (int c = 0; c < out.channels; ++c) out.at(x / kSide, y / kSide)[c] += picture.at(x, y)[c] / (kSide * kSide);
    return out;
}

double rmse_of(const PicturePair& pair) { return measure_rmse(pair).numbers[0].value; }

double reduced_rmse(const PicturePair& pair) {
    PicturePair small;
    small.reference = reduced(pair.reference), small.test = reduced(pair.test);
    small.counts.assign(small.pixels(), 1);
    return small.pixels() ? rmse_of(small) : rmse_of(pair);
}

}  // namespace

const char* name_of(Grade grade) {
    constexpr const char* kNames[] = {"exact", "match", "close", "off", "error"};
    return kNames[size_t(grade)];
}

Graded grade(const PicturePair& pair, bool noisy) {
    const PicturePair colors = colors_alone(pair);
    Graded out{Grade::off, noisy ? reduced_rmse(colors) : rmse_of(colors), measure_over2(colors).numbers[0].value, measure_envelope(colors).numbers[0].value};
    if (out.over2 <= 0.005) out.grade = Grade::exact;
    else if (noisy ? out.rmse <= 0.03 : out.rmse <= 0.02 && out.envelope <= 0.01) out.grade = Grade::match;
    else if (out.rmse <= 0.06) out.grade = Grade::close;
    return out;
}

}  // namespace alidade

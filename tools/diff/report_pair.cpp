// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/report_pair.h"

namespace alidade {
namespace {

Picture linear_picture(const PicturePair& pair, const Picture& picture) {
    Picture out;
    out.width = picture.width, out.height = picture.height, out.channels = 3;
    out.names = {"R", "G", "B"};
    out.values = linear_colors(pair, picture);
    return out;
}

}  // namespace

ReportPair report_pair(const Comparison& comparison, const std::string& name, std::vector<std::string> commands) {
    ReportPair out;
    out.name = name;
    out.document = to_json(comparison);
    out.commands = std::move(commands);
    if (!comparison.loaded || comparison.measured.empty()) return out;
    const LoadedPair& loaded = *comparison.loaded;
    const PicturePair& pair = loaded.pair;
    const bool odd = !loaded.odd.empty();
    out.reference = linear_picture(pair, odd ? loaded.shown[0] : pair.reference);
    out.test = linear_picture(pair, odd ? loaded.shown[1] : pair.test);
    out.linear = pair.hdr || loaded.fine || odd;   // a page's picture has 8 bits, and no NaN
    out.map = error_map(comparison);
    out.counts = pair.counts;
    return out;
}

}  // namespace alidade

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
    const PicturePair& pair = comparison.loaded->pair;
    const auto hdr = comparison.measured.find("hdr_flip");
    out.reference = linear_picture(pair, pair.reference);
    out.test = linear_picture(pair, pair.test);
    out.linear = pair.hdr;
    out.map = (hdr == comparison.measured.end() ? comparison.measured.at("flip") : hdr->second).map;
    out.counts = pair.counts;
    return out;
}

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Writes a report of four pairs for report_test.py: fine, broken in one corner, named in bad faith, and without pictures.
#include "tools/report/report.h"

#include <cstdio>
#include <functional>
#include <span>

namespace {

using namespace alidade;
using Json = nlohmann::ordered_json;

/// 8-bit codes as linear values: the page is to show the codes.
Picture of_codes(int width, int height, const std::function<int(int x, int y, int channel)>& code) {
    Picture picture(width, height, {"R", "G", "B"});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = float(srgb_to_linear(double(code(x, y, c)) / 255));
    return picture;
}

Json document(const char* verdict, int code, double flip) {
    return {{"schema", 1}, {"reference", "a.png"}, {"test", "b.png"}, {"verdict", verdict}, {"exit_code", code}, {"reason", std::string("it is a ") + verdict},
            {"metrics", {{"flip", {{"mean", flip}, {"max", 1e-7}}}, {"psnr", {{"value", nullptr}}}}}};
}

ReportPair pair(const std::string& name, const char* group, Json json) {
    ReportPair out;
    out.name = name, out.group = group, out.document = std::move(json);
    out.reference = of_codes(20, 10, [](int x, int y, int c) { return 10 * x + y + c; });
    out.test = of_codes(20, 10, [](int x, int y, int c) { return 10 * x + y + c + (x >= 12 && y < 4 ? 40 : 0); });
    for (int i = 0; i < 200; ++i) out.map.push_back(i % 20 >= 12 && i / 20 < 4 ? 0.6f : 0.0f);
    return out;
}

/// The left half is a ball, the right one a box, but for a row of nothing.
ReportObjects objects() {
    ReportObjects found;
    found.names = std::vector<std::string>(70000, "one of many");
    found.names[3] = "ball <1>";
    found.names[69999] = "box";
    for (uint32_t i = 0; i < 200; ++i) found.index.push_back(i / 20 == 9 ? 0xffffffff : i % 20 < 10 ? 3 : 69999);
    return found;
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) return 1;
    Report report{"Four <pairs> & more", {{"alidade", "1.2.3"}, {"povray", "3.7"}}, {}};
    report.pairs.push_back(pair("fine", "easy", document("pass", 0, 0.001)));
    report.pairs.push_back(pair("corner", "hard", document("fail", 2, 0.25)));
    report.pairs.back().objects = objects();
    report.pairs.back().statistics = {{"render", {{"seconds", 1.5}, {"rays", 12000}}}, {"warnings", {"one", "two"}}};
    report.pairs.back().document["tiles"] = {{"size", 8}, {"columns", 3}, {"rows", 2}, {"mean", {0, 0.05, 0.08, 0, 0, 0.0001}}, {"max", {0, 0.2, 0.2, 0, 0, 0.01}}};
    report.pairs.back().commands = {shell_line({"povray", "+Iit's.pov", "+W20"}), shell_line({"alidade", "diff", "a b.png", "c.png"})};
    report.pairs.push_back(pair("</script><img src=x onerror=document.title='caught'>", "hard", document("fail", 2, 0.5)));
    ReportPair none;
    none.name = "sizes";
    none.group = "easy";
    none.document = document("incomparable", 3, 0);
    none.document.erase("metrics");
    report.pairs.push_back(none);
    const auto html = report_html(report);
    if (!html) return std::fprintf(stderr, "%s\n", html.error().c_str()), 1;
    return write_file(words[1], std::as_bytes(std::span(*html))) ? 0 : 1;
}

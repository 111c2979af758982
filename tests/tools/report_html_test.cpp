// SPDX-License-Identifier: Apache-2.0
/// What the report's text promises; that the page works is report_test.py's.
#include "tools/report/report.h"

#include <functional>
#include <gtest/gtest.h>

namespace alidade {
namespace {

ReportPair small_pair() {
    ReportPair pair;
    pair.name = "a";
    pair.document = {{"verdict", "pass"}, {"exit_code", 0}};
    pair.reference = pair.test = Picture(2, 1, {"R", "G", "B"});
    pair.map = {0, 1};
    return pair;
}

size_t count(const std::string& text, const std::string& what) {
    size_t found = 0;
    for (size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
    return found;
}

TEST(ReportHtml, IsTheSameForTheSamePairs) {
    const Report report{"title", {}, {small_pair()}};
    EXPECT_EQ(report_html(report).value(), report_html(report).value());
}

TEST(ReportHtml, AsksForNothing) {
    const std::string html = report_html({"title", {}, {small_pair()}}).value();
    for (const char* outside : {"src=\"", "@import", "url(", "fetch(", "XMLHttpRequest"}) EXPECT_EQ(count(html, outside), 0u) << outside;
    EXPECT_NE(html.find("default-src 'none'"), html.npos);
}

TEST(ReportHtml, LetsNoTextEndItsScripts) {
    auto pair = small_pair();
    const std::string plain = report_html({"title", {}, {pair}}).value();
    pair.name = "</script><script>alert(1)</script>";
    pair.document["reason"] = "<!-- {{script}} \xff";
    pair.commands = {"</SCRIPT >"};
    const std::string html = report_html({"</title>{{data}}", {{"<b>", "</script>"}}, {pair}}).value();
    for (const char* tag : {"<script", "</script", "<!--", "</SCRIPT", "</title>", "const data ="}) EXPECT_EQ(count(html, tag), count(plain, tag)) << tag;
}

TEST(ReportHtml, RefusesWhatDoesNotFit) {
    const auto why = [](const std::function<void(ReportPair&)>& change) {
        auto pair = small_pair();
        change(pair);
        const auto html = report_html({"title", {}, {pair}});
        return html ? "" : html.error();
    };
    EXPECT_EQ(why([](ReportPair&) {}), "");
    const std::string sentence = "a: pictures, error map and objects have different sizes";
    EXPECT_EQ(why([](ReportPair& pair) { pair.map.pop_back(); }), sentence);
    EXPECT_EQ(why([](ReportPair& pair) { pair.test = Picture(1, 2, {"R", "G", "B"}); }), sentence);
    EXPECT_EQ(why([](ReportPair& pair) { pair.counts = {1}; }), sentence);
    EXPECT_EQ(why([](ReportPair& pair) { pair.objects = ReportObjects{{0}, {"x"}}; }), sentence);
}

TEST(ReportHtml, OfNoPairsIsAPage) { EXPECT_TRUE(report_html({"none", {}, {}})); }

TEST(ShellLine, QuotesWhatAShellWouldTakeApart) {
    EXPECT_EQ(shell_line({"alidade", "diff", "a.png", "--require", "flip.mean<0.02", "it's", ""}), "alidade diff a.png --require 'flip.mean<0.02' 'it'\\''s' ''");
}

}  // namespace
}  // namespace alidade

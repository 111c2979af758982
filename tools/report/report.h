// SPDX-License-Identifier: Apache-2.0
/// One HTML file that shows how pictures differ: opened from disk, without a network. Its page is report.html, report.css and report.js.
#pragma once

#include "core/image.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

/// Which object each pixel shows.
struct ReportObjects {
    std::vector<uint32_t> index;      ///< one a pixel, into `names`; what is past their end shows none
    std::vector<std::string> names;   ///< fewer than 2^24
};

struct ReportPair {
    std::string name;                            ///< the heading
    std::string group;                           ///< a family of pairs, counted by verdict; "" for none
    nlohmann::ordered_json document;             ///< as `diff --json` has it: the page shows its numbers
    Picture reference, test;                     ///< as write_picture takes them: linear, colours alone; both empty if there is nothing to show
    bool linear = false;                         ///< values beyond the display's matter: they can be inspected (as halves, 11 bits) and exposed
    std::vector<float> map;                      ///< FLIP error of each pixel, 0 .. 1; empty with the pictures
    std::vector<uint8_t> counts;                 ///< one a pixel, 0 where it is left out of the histogram; empty: all count
    std::optional<ReportObjects> objects;
    nlohmann::ordered_json statistics;           ///< an object of what else there is to tell (of renders), may nest; null for nothing
    std::vector<std::string> commands;           ///< that made the pictures and compared them, as a shell takes them
};

struct Report {
    std::string title;
    nlohmann::ordered_json versions;             ///< an object: program -> version
    std::vector<ReportPair> pairs;               ///< in any order: the page sorts them, the worst first
};

/// The page's text. An error is one sentence: a picture that cannot be encoded, sizes that differ.
///
/// Method   numbers and texts are one JSON block, pictures base64 PNGs (8 bit, sRGB; the error in steps of 1/255), decoded when a pair is opened. Everything that comes
///          from a file's name or content reaches the page as text alone, never as HTML; a content policy forbids every request.
tl::expected<std::string, std::string> report_html(const Report& report);

/// Words as one line that a shell takes apart into the same words.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
/// Other programs as rows: command templates, whose placeholders are axes.
#pragma once

#include "tools/tradeoff/axes.h"

#include "core/image.h"

namespace alidade::tradeoff {

/// 'povray +I{scene} +L{folder} +W{width} +H{height} +A{aa} +O{out} -D': split into words as a shell would, but nothing is run by one.
struct External {
    std::string text;
    Words words;
    std::vector<std::string> axes;   ///< placeholders that are not scene, folder, width, height, out, out.EXT
};
Value<External> parse_external(const std::string& text);

/// What the placeholders that are no axes stand for.
struct ExternalJob {
    std::string scene;
    int width = 0, height = 0;
    double timeout = 600;
};

struct ExternalRun {
    Picture picture;             ///< R G B, linear
    bool display = false;        ///< its file holds display values
    double cpu_seconds = 0;      ///< of the process and its children
};
/// Runs it in a folder that is thrown away. An error is one sentence, with the program's own complaint.
Value<ExternalRun> run_external(const External& external, const Setting& setting, const ExternalJob& job);

/// The words, as a shell takes them.
std::string command_line(const External& external, const Setting& setting, const ExternalJob& job, const std::string& out);

/// A file's colours: linear, over black where it is transparent.
struct LinearFile {
    Picture picture;
    uint32_t levels = 0;   ///< steps of its display values; 0: it is linear itself
};
Value<LinearFile> read_linear(const std::string& path);

}  // namespace alidade::tradeoff

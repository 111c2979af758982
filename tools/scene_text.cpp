// SPDX-License-Identifier: Apache-2.0
#include "tools/scene_text.h"

#include <cstdio>

namespace alidade {

void SceneText::print(pov::TextStream where, const std::string& text) {
    if (where == pov::TextStream::warning || where == pov::TextStream::error) return;
    text_ += text;
    if (shown_) std::fwrite(text.data(), 1, text.size(), stderr);
}

void SceneText::end_line() const {
    if (shown_ && line_is_open()) std::fputc('\n', stderr);
}

}  // namespace alidade

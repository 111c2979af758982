// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/extensions.h"

#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <set>
#include <sstream>

namespace alidade::gltf {
namespace {

const char* word(Support support) {
    switch (support) {
        case Support::full: return "full";
        case Support::harmless: return "harmless";
        case Support::ignored: return "ignored";
        default: return "needed";
    }
}

/// The page for users says what the table says, row by row.
TEST(Extensions, AreDocumented) {
    std::ifstream in(DOCS "/gltf-support.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const Extension& e : extensions()) EXPECT_THAT(page.str(), testing::HasSubstr(fmt::format("| `{}` | {} | {} |", e.name, word(e.support), e.doc)));
}

TEST(Extensions, AreFoundByName) {
    std::set<std::string> names;
    for (const Extension& e : extensions()) {
        EXPECT_TRUE(names.insert(e.name).second) << e.name << " is there twice";
        EXPECT_EQ(find_extension(e.name), &e);
    }
    EXPECT_EQ(find_extension("ACME_x"), nullptr);
}

}  // namespace
}  // namespace alidade::gltf

// SPDX-License-Identifier: Apache-2.0
#include "tools/json.h"
#include "tools/progress.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace alidade {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(AsText, AlignsKeysAndTables) {
    const Json document = {{"scene", "a.glb"}, {"box", {{"min", {0, 1}}, {"max", {2, 3}}}}, {"none of these", Json::array()},
                           {"lights", {{{"name", "key"}, {"power", 1.5}}, {{"name", "f\u00fcll"}, {"power", 12}}}}};
    EXPECT_EQ(as_text(document), "scene:         a.glb\n"
                                 "box:           min 0 1, max 2 3\n"
                                 "none of these: none\n"
                                 "\n"
                                 "lights:\n"
                                 "  name  power\n"
                                 "  key     1.5\n"
                                 "  f\u00fcll     12\n");
}

TEST(AsJsonText, SurvivesNamesThatAreNotUtf8) {
    const std::string text = as_json_text({{"name", "\xff\xfe"}});
    EXPECT_EQ(Json::parse(text).at("name"), "\ufffd\ufffd");
}

TEST(ToJson, NamesThePlaceOfADiagnostic) {
    Diagnostics said;
    said.warning({said.add_file("a.gltf"), 3, 7, ""}, "odd", "mend it");
    const Json list = to_json(said);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].at("severity"), "warning");
    EXPECT_EQ(list[0].at("where"), "a.gltf:3:7");
    EXPECT_EQ(list[0].at("hint"), "mend it");
}

TEST(ProgressBar, TellsPercentAndTimeLeft) {
    const std::string half = progress_bar(0.5, 75, 60);
    EXPECT_THAT(half, HasSubstr(" 50 %"));
    EXPECT_THAT(half, HasSubstr("1:15 left"));
    EXPECT_THAT(progress_bar(0, 75, 60), Not(HasSubstr("left")));
    EXPECT_THAT(progress_bar(0.01, 100, 60), HasSubstr("2:45:00 left"));
    EXPECT_THAT(progress_bar(1e-9, 3600, 60), HasSubstr("99:59:59 left"));
}

TEST(ProgressBar, FitsTheTerminalAndGrows) {
    for (const int columns : {0, 1, 10, 25, 40, 79, 200})
        for (const double fraction : {0.0, 0.3, 1.0}) EXPECT_LE(progress_bar(fraction, 10, columns).size(), size_t(columns));
    size_t before = 0;
    for (const double fraction : {0.0, 0.25, 0.5, 1.0}) {
        const std::string bar = progress_bar(fraction, 10, 79);
        const auto full = size_t(std::count(bar.begin(), bar.end(), '#'));
        EXPECT_TRUE(full > before || fraction == 0) << bar;
        before = full;
    }
    EXPECT_THAT(progress_bar(1, 10, 79), Not(HasSubstr(".")));
}

}  // namespace
}  // namespace alidade

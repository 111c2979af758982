// SPDX-License-Identifier: Apache-2.0
/// What is written for POV-Ray, in a folder of its own, and read again.
#pragma once

#include "exporters/exporter.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/core/folder_test.h"

#include <string>

namespace alidade::test {

class PovFile : public FolderTest {
  protected:
    std::string exported(const Scene& scene) {
        const std::string path = (folder_ / "scene.pov").string();
        const auto done = export_scene(scene, path);
        EXPECT_TRUE(done) << (done ? "" : done.error());
        lost_.clear(), told_.clear();
        if (done)
            for (const Loss& loss : done->losses) lost_ += loss.what + "\n", told_ += loss.instead + "\n";
        return text("scene.pov");
    }

    Scene again() {
        auto read = import_scene((folder_ / "scene.pov").string());
        EXPECT_TRUE(read) << (read ? "" : read.error().text());
        if (!read) return {};
        EXPECT_FALSE(validate(read->scene).has_errors());
        return std::move(read->scene);
    }

    std::string lost_, told_;
};

}  // namespace alidade::test

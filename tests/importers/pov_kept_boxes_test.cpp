// SPDX-License-Identifier: Apache-2.0
/// The boxes of nodes, beside what min_extent() and max_extent() of POV-Ray 3.7 say of the same objects.
#include "eval/kept_boxes.h"
#include "importers/importer.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

struct Kept {
    const char* object;
    Vec3 low, high;
};

const Kept kKept[] = {
    {"disc { 0, <1,1,-2>, .5 }", {-.5004, -.5004, -.4091}, {.5004, .5004, .4091}},
    {"disc { 0, z, .5 rotate 30*y }", {-.4335, -.5, -.2509}, {.4335, .5, .2509}},
    {"sphere { 0, 1 clipped_by { disc { 0, z, .5 } } }", {-.5, -.5, -.001}, {.5, .5, .001}},
    {"plane { y, 0 clipped_by { disc { 0, z, .5 } } }", {-.5, -.5, -.001}, {.5, .5, .001}},
    {"box { -1, 1 clipped_by { disc { 0, z, .5 inverse } } }", {-1, -1, -1}, {1, 1, 1}},
    {"box { -1, 1 clipped_by { intersection { disc { 0, z, .5 } sphere { 0, .4 } } } }", {-.4, -.4, -.001}, {.4, .4, .001}},
    {"box { -1, 1 clipped_by { union { disc { 0, z, .5 } sphere { 0, .4 } } } }", {-.5, -.5, -.4}, {.5, .5, .4}},
    {"box { -1, 1 clipped_by { disc { 0, z, .5 } sphere { 0, .4 } } }", {-.4, -.4, -.001}, {.4, .4, .001}},
    {"intersection { box { -1, 1 } disc { 0, z, .5 } }", {-.5, -.5, -.001}, {.5, .5, .001}},
    {"intersection { plane { y, .3 bounded_by { box { -.6, .6 } } } box { -1, 1 } }", {-1, -1, -1}, {1, .3, 1}},
    {"intersection { plane { y, .3 clipped_by { sphere { 0, .6 } } } box { -1, 1 } }", {-1, -1, -1}, {1, .3, 1}},
    {"difference { box { -1, 1 } plane { y, .3 inverse bounded_by { box { -.6, .6 } } } }", {-1, -1, -1}, {1, .3, 1}},
    {"difference { box { -1, 1 } disc { 0, z, .5 } }", {-1, -1, -1}, {1, 1, 1}},
    {"box { -1, 1 bounded_by { sphere { 0, .9 bounded_by { sphere { 0, .3 } } } } }", {-.3, -.3, -.3}, {.3, .3, .3}},
    {"box { -1, 1 bounded_by { sphere { 0, .9 clipped_by { sphere { 0, .3 } } } } }", {-.3, -.3, -.3}, {.3, .3, .3}},
    {"box { -1, 1 bounded_by { sphere { 0, .9 clipped_by { box { 0, 1 } } } } }", {0, 0, 0}, {1, 1, 1}},
    {"sphere { 0, 1 scale <2,1,1> rotate 45*z }", {-2.1213, -2.1213, -1}, {2.1213, 2.1213, 1}},
    {"union { sphere { 0, 1 bounded_by { sphere { 0, .3 } } } sphere { x, .1 bounded_by { sphere { 2*x, .5 } } } }", {-.3, -.3, -.3}, {1.1, .3, .3}},
    {"cylinder { -.6*y, .6*y, .6 bounded_by { sphere { <.2,.2,-.1>, .6 } } translate <1,.5,.3> }", {.4, -.1, -.3}, {1.6, 1.1, .9}},
    {"cylinder { -x, x, 2 bounded_by { sphere { 0, .9 bounded_by { sphere { <.2,.2,-.1>, .4 } } } } translate y }", {-.9, .1, -.9}, {.9, 1.9, .9}},
    {"cylinder { -x, x, 2 bounded_by { torus { .5, .3 bounded_by { sphere { <.2,.2,-.1>, .4 } } } } translate y }", {-.8, .7, -.8}, {.8, 1.3, .8}},
    {"cylinder { -x, x, 2 bounded_by { quadric { <1,1,1>, 0, 0, -.81 bounded_by { sphere { <.2,.2,-.1>, .4 } } } } translate y }", {-.2, .8, -.5}, {.6, 1.6, .3}},
    {"cylinder { -x, x, 2 bounded_by { intersection { sphere { 0, .9 } box { -.8, .8 } bounded_by { sphere { <.2,.2,-.1>, .4 } } } } rotate 45*z }", {-.5657, -.2828, -.5}, {.5657, .8485, .3}},
    {"cylinder { -x, x, 2 bounded_by { plane { y, 0 clipped_by { sphere { <.2,.2,-.1>, .4 } } } } translate y }", {-.2, .8, -.5}, {.6, 1.6, .3}},
    {"merge { cylinder { 0, y, 1 } cylinder { y, 2*y, 1 } }", {-1, 0, -1}, {1, 2, 1}},
    // limits that are apart
    {"cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } }", {.1, -1, -1}, {-.1, 1, 1}},
    {"cylinder { -y, y, 1 clipped_by { box { <-1,-1,-1>, <-.9,1,1> } box { <.9,-1,-1>, 1 } } }", {.9, -1, -1}, {-.9, 1, 1}},
    {"cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,-.1,1> } box { <.1,.1,-1>, 1 } } }", {.1, .1, -1}, {-.1, -.1, 1}},
    {"cylinder { -y, y, 1 bounded_by { box { <-3,-3,-1>, <-2,-2,1> } box { <2,2,-1>, <3,3,1> } } }", {-1, -1, -1}, {1, 1, 1}},
    {"cylinder { -y, y, 1 bounded_by { box { -1, -.1 } box { .1, 1 } } }", {.1, .1, .1}, {-.1, -.1, -.1}},
    {"cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } clipped_by { box { -.1, .1 } } }", {.1, -1, -1}, {-.1, 1, 1}},
    {"cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } translate 5*x }", {5.1, -1, -1}, {4.9, 1, 1}},
    {"cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } rotate 20*z }", {-.2481, -.9055, -1}, {.2481, .9055, 1}},
    {"union { cylinder { -y, y, 1 bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } } sphere { 2*x, .5 } }", {.1, -1, -1}, {2.5, 1, 1}},
    {"sphere { 0, 2 bounded_by { merge { sphere { 0, 1 } box { -1, 1 } bounded_by { box { <-1,-1,-1>, <-.1,1,1> } box { <.1,-1,-1>, 1 } } } } translate 2*x }", {1.9, -1, -1}, {2.1, 1, 1}},
    // quadrics and what clips them
    {"quadric { <1,-1,1>, 0, 0, -.2 clipped_by { plane { y, .5 } plane { -y, .5 } } }", {-1.118, -.5, -1.118}, {1.118, .5, 1.118}},
    {"quadric { <1,-1,1>, 0, 0, 0 clipped_by { plane { y, .5 } plane { y, -.5 inverse } } }", {-.5, -.5, -.5}, {.5, .5, .5}},
    {"quadric { <1,0,1>, 0, 0, -.2 clipped_by { box { -1, 1 } } }", {-.4472, -1, -.4472}, {.4472, 1, .4472}},
    {"quadric { <1,0,1>, 0, -y, 0 clipped_by { plane { y, .5 } } rotate 90*z }", {-.5, -.7071, -.7071}, {0, .7071, .7071}},
    {"quadric { <1,1,1>, 0, 0, -1 clipped_by { plane { y, .5 } plane { -y, .5 } sphere { 0, .8 } } }", {-.8, -.5, -.8}, {.8, .5, .8}},
    {"quadric { <1,1,1>, 0, 0, -1 clipped_by { box { -.5, 1 } } bounded_by { box { -1, .7 } } }", {-.5, -.5, -.5}, {1, 1, 1}},
    {"quadric { <1,-1,1>, 0, 0, -.2 clipped_by { plane { y, .5 } box { -1, 1 } sphere { 0, .5 inverse } } }", {-1, -1, -1}, {1, .5, 1}},
    {"quadric { <1,0,1>, 0, -y, 0 translate -.3*y clipped_by { box { -1, 1 } } }", {-.8367, .3, -.8367}, {.8367, 1, .8367}},
    {"quadric { <1,0,1>, 0, -y, 0 translate -y clipped_by { plane { y, .5 } } }", {-.7071, 1, -.7071}, {.7071, .5, .7071}},
    {"intersection { quadric { <1,0,1>, 0, 0, -.2 clipped_by { plane { y, .5 } plane { -y, .5 } } } sphere { 0, 10 } }", {-.4472, -.5, -.4472}, {.4472, .5, .4472}},
};

TEST(PovKeptBoxes, AreThoseOfPovRay) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / fmt::format("alidade_kept_boxes_{}.pov", std::random_device{}());
    for (const Kept& kept : kKept) {
        std::ofstream(file) << "#version 3.7; global_settings { assumed_gamma 1 }\n" << kept.object << "\n";
        const auto imported = import_scene(file.string());
        ASSERT_TRUE(imported) << kept.object;
        const Scene& scene = imported->scene;
        const NodeId root = scene.roots.front();
        const Bounds box = KeptBoxes(scene).of(root, scene.nodes[root.index].to_parent);
        EXPECT_LT(max_abs(box.min - kept.low), 1e-4) << kept.object;
        EXPECT_LT(max_abs(box.max - kept.high), 1e-4) << kept.object;
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace alidade

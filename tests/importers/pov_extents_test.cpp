// SPDX-License-Identifier: Apache-2.0
/// The boxes that min_extent() and max_extent() give, beside POV-Ray's: how each way of making, moving, cutting and bounding an object changes them.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "tests/povray/povray.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sstream>

using namespace alidade;
using namespace alidade::pov;

namespace {

/// A name, and what it is declared as: A, or B made of the A before it.
struct Declared {
    char name;
    const char* object;
};

const Declared kDeclared[] = {
    {'A', "sphere{0,1 scale <1,2,3> rotate 45*z rotate 45*z}"},
    {'A', "sphere{0,1 scale <1,2,3> rotate 90*z}"},
    {'A', "sphere{0,1 scale <1,2,3> rotate 45*z}"},
    {'B', "object{A rotate 45*z}"},
    {'A', "sphere{<1,0,0>,1 scale 2 rotate 45*z}"},
    {'A', "sphere{<1,0,0>,1 matrix <1,.5,0, 0,1,0, 0,0,1, 0,0,0>}"},
    {'A', "sphere{0,1 scale <1,-1,1>}"},
    {'A', "cylinder{0,x,.5 rotate 45*z rotate 45*z}"},
    {'A', "cylinder{0,x,.5 rotate 45*z}"},
    {'A', "cylinder{0,<1,1,0>,.5}"},
    {'A', "cylinder{0,<1,1,0>,.5 rotate 45*z}"},
    {'A', "cylinder{<1,2,3>,<2,4,4>,.5 scale <1,2,3>}"},
    {'A', "cone{0,1,x,.5 rotate 45*z}"},
    {'A', "cone{0,1,x,.5 rotate 45*z rotate 45*z}"},
    {'A', "cone{0,1,<1,1,1>,.5}"},
    {'A', "cone{0,1,<1,1,1>,-.5}"},
    {'A', "torus{1,.25 rotate 45*z}"},
    {'A', "torus{1,.25 rotate 45*z rotate 45*z}"},
    {'A', "disc{0,x,1}"},
    {'A', "disc{0,<1,1,1>,1}"},
    {'A', "disc{0,<1,1,1>,1 rotate 30*z}"},
    {'A', "disc{0,y,1 rotate 45*z rotate 45*z}"},
    {'A', "disc{<1,2,3>,<0,0,2>,3,1}"},
    {'A', "box{-1,1 scale <1,2,3> rotate 45*z rotate 45*z}"},
    {'A', "box{<1,1,1>,<0,-1,-2>}"},
    {'A', "union{box{-1,1 rotate 45*z} rotate 45*z}"},
    {'A', "union{box{-1,1} rotate 45*z rotate 45*z}"},
    {'A', "union{box{-1,1 rotate 45*z} sphere{0,.1} rotate 45*z}"},
    {'A', "union{sphere{<1,0,0>,1} rotate 45*z}"},
    {'A', "union{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} rotate 45*z}"},
    {'B', "union{A rotate 45*z}"},
    {'A', "union{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} rotate 45*z bounded_by{box{-3,3}}}"},
    {'A', "union{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} bounded_by{box{-3,3}} rotate 45*z}"},
    {'A', "union{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} bounded_by{sphere{0,3}} rotate 45*z}"},
    {'A', "union{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} bounded_by{sphere{0,.3}}}"},
    {'A', "sphere{0,1 bounded_by{box{0,3}}}"},
    {'A', "intersection{sphere{0,1} box{-1,.5} rotate 45*z}"},
    {'A', "intersection{sphere{0,1} plane{x,0} rotate 45*z}"},
    {'A', "intersection{sphere{0,1} plane{x,0 rotate 45*z}}"},
    {'A', "intersection{box{-1,1} plane{y,0} plane{x,.5} plane{-z,.25}}"},
    {'A', "difference{box{-1,1} plane{y,0} rotate 30*z}"},
    {'A', "difference{box{-1,1} sphere{0,.5 inverse}}"},
    {'A', "intersection{box{-1,1} sphere{0,.5 inverse}}"},
    {'A', "intersection{sphere{0,.5 inverse} sphere{0,1 inverse}}"},
    {'A', "intersection{plane{y,0} plane{-y,1}}"},
    {'A', "merge{sphere{<1,0,0>,1} sphere{<-1,0,0>,1} rotate 45*z}"},
    {'A', "merge{sphere{<1,0,0>,1} plane{y,0}}"},
    {'A', "union{sphere{<1,0,0>,1} plane{y,0} translate x}"},
    {'A', "plane{y,0 translate 5}"},
    {'A', "quadric{<1,0,1>,0,0,-1}"},
    {'A', "quadric{<1,2,3>,0,0,-1 rotate 30*z}"},
    {'A', "intersection{quadric{<1,0,1>,0,0,-1} plane{y,1} plane{-y,1}}"},
    {'A', "intersection{quadric{<1,2,3>,0,0,-1} box{-5,5}}"},
    {'A', "quadric{<1,2,3>,0,0,-1 bounded_by{sphere{0,2}}}"},
    {'A', "poly{4,<1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0, 1,0,0,0,0,0,0,0,0,0, 1,0,0,0,-1>}"},
    {'A', "mesh{triangle{0,x,y} triangle{0,x,<.1,.3,.7>} rotate 45*z rotate 45*z}"},
    {'A', "triangle{0,x,y rotate 45*z rotate 45*z}"},
    {'A', "triangle{0,x,y rotate 45*z}"},
    {'A', "object{triangle{0,x,y rotate 45*z} rotate 45*z}"},
    {'A', "triangle{0,x,y scale <2,1,1>}"},
    {'A', "smooth_triangle{0,-z,x,-z,y,-z rotate 45*z}"},
    {'A', "polygon{5,<0,0>,<1,0>,<1,1>,<0,1>,<0,0> rotate 45*z}"},
    {'A', "polygon{5,<0,0,0>,<1,0,0>,<1,1,1>,<0,1,1>,<0,0,0>}"},
    {'A', "polygon{5,<0,0,0>,<1,0,0>,<1,1,1>,<0,1,1>,<0,0,0> rotate 45*y rotate 45*y}"},
    {'A', "polygon{5,<0,0>,<1,0>,<1,1>,<0,1>,<0,0> translate 3*z}"},
    {'A', "sphere{0,1 scale 1e6}"},
    {'A', "torus{-1,-.25}"},
    {'A', "disc{0,y,-1}"},
    {'A', "union{sphere{0,1} sphere{5,1} clipped_by{box{0,2}}}"},
    {'A', "sphere{0,1 clipped_by{box{0,2}} bounded_by{clipped_by}}"},
    {'A', "plane{y,0 clipped_by{box{0,2}} bounded_by{clipped_by}}"},
    {'A', "plane{y,0 bounded_by{box{0,2}}}"},
    {'A', "plane{y,0 clipped_by{box{0,2}}}"},
    {'A', "sphere{0,1 clipped_by{box{-.1,1}}}"},
    {'A', "sphere{0,1 bounded_by{box{-.1,1}}}"},
    {'A', "sphere{0,1 bounded_by{box{.5,1.4}}}"},
    {'A', "sphere{0,1 clipped_by{box{.5,1.4}}}"},
    {'A', "sphere{0,1 bounded_by{box{5,5.4}}}"},
    {'A', "sphere{0,1 bounded_by{box{-.5,.5}} bounded_by{box{-.1,.1}}}"},
    {'A', "sphere{0,1 bounded_by{box{-.5,.5} box{0,.9}}}"},
    {'A', "sphere{0,1 clipped_by{box{-.5,.5} box{0,.9}}}"},
    {'A', "sphere{0,1 bounded_by{box{-.5,.5}} rotate 45*z}"},
    {'A', "sphere{0,1 bounded_by{box{-.5,.5} rotate 45*z}}"},
    {'A', "box{-1,1 bounded_by{box{-.5,.5}} rotate 45*z}"},
    {'A', "box{-1,1 clipped_by{box{-.5,.5}} rotate 45*z}"},
    {'A', "box{-1,1 rotate 45*z clipped_by{box{-.5,.5}}}"},
    {'A', "object{A rotate 45*z}"},
    {'A', "union{sphere{0,1} box{0,2} clipped_by{box{.5,3}}}"},
    {'A', "union{sphere{0,1} box{0,2} clipped_by{sphere{0,1 inverse}}}"},
    {'A', "union{sphere{0,1} box{0,2} clipped_by{plane{x,0}}}"},
    {'A', "union{sphere{0,1} plane{y,0} bounded_by{box{-3,3}}}"},
    {'A', "union{sphere{0,1} plane{y,0} clipped_by{box{-3,3}} translate 5}"},
    {'A', "plane{y,0 clipped_by{box{-3,3}} rotate 45*z}"},
    {'A', "quadric{<1,2,3>,0,<1,1,1>,-1}"},
    {'A', "quadric{<-1,-2,-3>,0,<1,1,1>,1}"},
    {'A', "quadric{<1,-2,3>,0,0,-1}"},
    {'A', "quadric{<1,2,3>,0,0,1}"},
    {'A', "quadric{<1,2,3>,0,0,0}"},
    {'A', "intersection{quadric{<1,0,1>,0,0,-1} box{-5,5}}"},
    {'A', "intersection{quadric{<1,0,1>,0,0,-1} sphere{0,3}}"},
    {'A', "intersection{quadric{<1,0,-1>,0,0,-1} sphere{0,3}}"},
    {'A', "intersection{quadric{<1,2,1>,0,0,-1 inverse} sphere{0,3}}"},
    {'A', "intersection{quadric{<1,1,-1>,0,0,0} plane{z,2} plane{-z,0}}"},
    {'A', "intersection{quadric{<1,0,1>,0,<0,-1,0>,0} plane{y,2}}"},
    {'A', "intersection{quadric{<1,0,1>,0,0,-1} plane{y,1}}"},
    {'A', "intersection{plane{x,1} sphere{0,3} plane{-x,-.5}}"},
    {'A', "intersection{plane{2*x,1} sphere{0,3}}"},
    {'A', "intersection{plane{x,1 scale 2} sphere{0,3}}"},
    {'A', "intersection{plane{x,1 translate .5*x} sphere{0,3}}"},
    {'A', "intersection{plane{x,1 inverse} sphere{0,3}}"},
    {'A', "difference{sphere{0,3} plane{x,1}}"},
    {'A', "difference{sphere{0,3} plane{x,1 inverse}}"},
    {'A', "intersection{union{plane{x,1} sphere{0,1}} sphere{0,3}}"},
    {'A', "intersection{intersection{plane{x,1} plane{y,1}} sphere{0,3}}"},
    {'A', "intersection{object{plane{y,0} rotate 90*z} sphere{0,3}}"},
    {'A', "difference{box{-1,1} union{plane{x,0} plane{y,0}}}"},
    {'A', "difference{box{-1,1} intersection{plane{x,0} plane{y,0}}}"},
    {'A', "union{sphere{0,1} sphere{4,1} inverse}"},
    {'A', "intersection{sphere{0,1} sphere{.5,1} inverse}"},
    {'A', "intersection{union{sphere{0,1} sphere{4,1} inverse} box{-9,9}}"},
    {'A', "intersection{union{sphere{0,1 inverse} sphere{4,1 inverse}} box{-9,9}}"},
    {'A', "polygon{4,<0,0>,<1,0>,<0,1>,<0,0> rotate 45*z}"},
    {'A', "polygon{4,<0,0,0>,<1,0,0>,<0,1,1>,<0,0,0> rotate 45*y}"},
    {'A', "polygon{4,<0,0,0>,<1,0,0>,<0,1,1>,<0,0,0> }"},
    {'A', "mesh{triangle{0,x,y} scale 0}"},
    {'A', "sphere{x,1 rotate 45*z scale <1,2,1>}"},
    {'A', "sphere{x,1 transform{rotate 45*z} scale <1,2,1>}"},
    {'A', "sphere{x,1 transform{rotate 45*z}}"},
    {'A', "sphere{x,1 transform{rotate 45*z scale 2}}"},
    {'A', "sphere{x,1 matrix<1,0,0,0,1,0,0,0,1,3,0,0>}"},
    {'A', "sphere{x,1 matrix<0,1,0,-1,0,0,0,0,1,3,0,0> rotate 45*z}"},
    {'A', "sphere{x,1 scale -2}"},
    {'A', "sphere{x,1 scale <2,-2,2> rotate 45*z}"},
    {'A', "plane{y,0 scale 1e-5}"},
    {'A', "union{plane{y,0} scale 1e-5 scale 1e5}"},
    {'A', "union{plane{y,0} rotate 45*z}"},
    {'A', "object{union{sphere{0,.1} sphere{1,.1}} transform{rotate 45*z rotate 45*z}}"},
    {'A', "cone{0,1,x,1}"},
    {'A', "cone{0,.5,-z,1}"},
    {'A', "cylinder{0,-z,1}"},
    {'A', "cylinder{<1,1,1>,<1.5,.2,.7>,1}"},
    {'A', "cone{<1,1,1>,.25,<1.5,.2,.7>,1}"},
    {'A', "cone{<1,1,1>,1,<1.5,.2,.7>,.25}"},
    {'A', "disc{<1,2,3>,<.3,-.7,-.2>,2}"},
    {'A', "quadric{<1,2,3>,0,0,-1 rotate 45*z rotate 45*z}"},
    {'A', "quadric{<1,2,3>,0,0,-1 scale <2,3,1> rotate 45*z translate x}"},
    {'A', "quadric{<1,2,3>,<.5,.2,0>,0,-1 rotate 45*z rotate 45*z}"},
    {'A', "cone{<1,1,1>,.5,<1.5,.2,.7>,.5}"},
    {'A', "cone{<1,1,1>,-.5,<1.5,.2,.7>,.25}"},
    {'A', "cone{<1,1,1>,.25,<1.5,.2,.7>,-.5}"},
    {'A', "cone{<1,1,1>,.5,<1.5,.2,.7>,0}"},
    {'A', "cone{<1,1,1>,0,<1.5,.2,.7>,.5}"},
    {'A', "cylinder{<1,1,1>,<1.5,.2,.7>,.5}"},
    {'A', "cone{<1,1,1>,.50000001,<1.5,.2,.7>,.5}"},
    {'A', "text{ttf \"timrom.ttf\" \" \" 1,0}"},
    {'A', "text{ttf \"timrom.ttf\" \"  \" 1,.1*x+.1*y}"},
    {'A', "text{ttf \"timrom.ttf\" \"A \" 1,0}"},
    {'A', "text{ttf \"timrom.ttf\" \" A\" 1,0}"},
    {'A', "text{ttf \"timrom.ttf\" \"Hj\" 1,0}"},
    {'A', "text{ttf \"timrom.ttf\" \"jjA\" 1,<.1,.2,0>}"},
    {'A', "text{ttf \"timrom.ttf\" \"AV b \" 1,y*.1}"},
    {'A', "text{ttf \"timrom.ttf\" \"j\" 1,0}"},
    {'A', "text{ttf \"timrom.ttf\" \"To gj\" 1,.1*x}"},
    {'A', "cone{<1,1,1>,.5,<1.5,.2,.7>,.50000001}"},
    {'A', "cylinder{-x,x,.7 bounded_by{sphere{0,.9 bounded_by{sphere{<.2,.2,-.1>,.4}}}}}"},
    {'A', "cylinder{-x,x,.7 bounded_by{sphere{0,.9 bounded_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{torus{.5,.3 bounded_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{quadric{<1,1,1>,0,0,-.81 bounded_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{intersection{sphere{0,.9} box{-.8,.8} bounded_by{sphere{<.2,.2,-.1>,.4}}}} rotate 45*z}"},
    {'A', "cylinder{-x,x,2 bounded_by{sphere{0,.9 bounded_by{sphere{<.2,.2,-.1>,.4}}} translate y}}"},
    {'A', "cylinder{-x,x,2 clipped_by{sphere{0,.9 clipped_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{plane{y,0 bounded_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{quadric{<1,-1,1>,0,0,-.2 bounded_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'A', "cylinder{-x,x,2 bounded_by{plane{y,0 clipped_by{sphere{<.2,.2,-.1>,.4}}}} translate y}"},
    {'B', "object{A translate y}"},
    {'A', "cylinder{-y,y,1 bounded_by{box{-1,<-.1,1,1>} box{<.1,-1,-1>,1}}}"},
    {'B', "object{A rotate 20*z}"},
    {'A', "union{cylinder{-y,y,1 bounded_by{box{-1,<-.1,1,1>} box{<.1,-1,-1>,1}}} sphere{2*x,.5} scale 2}"},
    {'A', "merge{sphere{0,1} box{-1,1} bounded_by{box{-1,<-.1,1,1>} box{<.1,-1,-1>,1}} rotate 20*z}"},
    {'A', "intersection{box{-1,<-.1,1,1>} box{<.1,-1,-1>,1} bounded_by{box{-.2,.2}}}"},
    {'A', "quadric{<1,-1,1>,0,0,-.3 clipped_by{plane{y,.5} plane{-y,.5}}}"},
    {'B', "object{A rotate 45*z}"},
    {'A', "quadric{<-1,2,-3>,0,0,.3 clipped_by{plane{y,1} plane{-y,.5}}}"},
    {'A', "quadric{<1,-1,2>,0,x,-4 clipped_by{box{<-3,-.5,-3>,<3,.5,3>}}}"},
    {'A', "quadric{<1,1,-1>,0,<.2,0,.3>,-.3 clipped_by{box{<-3,-3,-.5>,<3,3,.5>}}}"},
    {'A', "quadric{<1,1,-1>,0,<.2,0,.3>,.3 clipped_by{box{<-3,-3,-.5>,<3,3,.5>}}}"},
    {'A', "intersection{quadric{<1,-1,1>,0,.4*y,-.3} plane{y,1} plane{-y,.5}}"},
    {'A', "quadric{<1,0,1>,0,-y,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<-1,0,-1>,0,2*y,.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,2>,0,y,-2 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,1>,0,<.4,-1,0>,0 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,2>,0,<.4,0,.3>,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,-1>,0,y,-.3 clipped_by{box{<-3,-3,-.5>,<3,3,.5>}}}"},
    {'A', "quadric{<1,0,0>,0,-y,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,2,1>,0,<.4,0,.3>,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,1>,0,<-.2,-1,-.2>,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<2,0,1>,0,<.4,-1,.8>,-.3 clipped_by{box{-3,3}}}"},
    {'A', "quadric{<1,0,1>,0,-y,-2 clipped_by{box{-1,1}}}"},
    {'A', "quadric{<1,0,1>,0,-y,-1 clipped_by{plane{y,.5}}}"},
    {'B', "object{A translate y}"},
    {'A', "quadric{<1,1,1>,0,-4*y,3 clipped_by{box{-.5,.5}}}"},
};

std::string program() {
    std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#macro Put(V) #debug concat(str(V.x, 0, 17), \"\\n\", str(V.y, 0, 17), \"\\n\", str(V.z, 0, 17), \"\\n\") #end\n";
    for (const Declared& d : kDeclared) text += fmt::format("#declare {} = {}\nPut(min_extent({})) Put(max_extent({}))\n", d.name, d.object, d.name, d.name);
    return text;
}

std::vector<double> numbers(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> all;
    for (std::string word; in >> word;) all.push_back(std::strtod(word.c_str(), nullptr));
    return all;
}

/// POV-Ray's letters are a little larger than they are.
double allowed(const Declared& d) { return std::string(d.object).find("text") == std::string::npos ? 1e-6 : 1e-4; }

}  // namespace

TEST(PovExtents, BoxesAreThoseThatPovRayKeeps) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    Diagnostics said;
    read_program_text("scene.pov", program(), options, said);
    ASSERT_FALSE(said.has_errors()) << said.text();
    const std::vector<double> ours = numbers(printed), theirs = numbers(povray_debug(program()));
    ASSERT_EQ(ours.size(), 6 * std::size(kDeclared));
    ASSERT_EQ(theirs.size(), ours.size());
    for (size_t i = 0; i < ours.size(); ++i) EXPECT_LE(std::abs(ours[i] - theirs[i]), allowed(kDeclared[i / 6]) * std::max(1.0, std::abs(theirs[i]))) << kDeclared[i / 6].object << " [" << i % 6 << "]";
}

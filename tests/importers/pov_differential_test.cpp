// SPDX-License-Identifier: Apache-2.0
/// The same expressions by POV-Ray itself: all go into one scene, which prints their values with #debug, and both programs must print the same.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "tests/povray/povray.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

using namespace alidade;
using namespace alidade::pov;

namespace {

/// A scene whose output is one line a value.
struct Questions {
    std::string prelude, text;
    std::vector<std::string> asked;

    void line(const std::string& expression, const std::string& what) {
        text += fmt::format("#debug concat({}, \"\\n\")\n", expression);
        asked.push_back(what);
    }
    void number(const std::string& expression) { line(fmt::format("str({}, 0, 17)", expression), expression); }
    void vector(const std::string& expression, int terms) {
        text += fmt::format("#declare V_ = {};\n", expression);
        for (int i = 0; i < terms; ++i) line(fmt::format("str(V_.{}, 0, 17)", std::vector{"x", "y", "z", "filter", "transmit"}[size_t(i)]), fmt::format("{} [{}]", expression, i));
    }
};

/// Random expressions whose values stay small and defined.
class Generator {
  public:
    std::string number(int depth) {
        if (depth == 0) return literal();
        const std::string a = number(depth - 1), b = number(depth - 1);
        switch (random(16)) {
            case 0: case 1: return fmt::format("{} + {}", a, b);
            case 2: return fmt::format("{} - {}", a, b);
            case 3: return fmt::format("({}) * ({})", a, b);
            case 4: return fmt::format("{} * {}", a, literal());
            case 5: return fmt::format("({}) / (abs({}) + .5)", a, b);
            case 6: return fmt::format("sin({}) - cos({})", a, b);
            case 7: return fmt::format("-({})", a);
            case 8: return fmt::format("({} {} {} ? {} : {})", a, comparison(), b, a, literal());
            case 9: return fmt::format("mod({}, {})", a, literal());
            case 10: return fmt::format("floor({}) + int({}) * ceil({})", a, b, literal());
            case 11: return fmt::format("min({}, {}, {})", a, b, literal());
            case 12: return fmt::format("({} {} {} {} {})", a, comparison(), b, random(2) ? "&" : "|", literal());
            case 13: return fmt::format("vdot({}, {})", vector(depth - 1), vector(depth - 1));
            case 14: return fmt::format("({}).{}", vector(depth - 1), "xyz"[random(3)]);
            default: return fmt::format("sqrt(abs({})) - !({})", a, b);
        }
    }

    std::string vector(int depth) {
        if (depth <= 0) return random(2) ? fmt::format("<{}, {}, {}>", literal(), literal(), literal()) : std::string(1, "xyz"[random(3)]);
        const std::string a = vector(depth - 1), b = vector(depth - 1);
        switch (random(6)) {
            case 0: return fmt::format("{} + {}", a, b);
            case 1: return fmt::format("({}) * ({})", a, b);
            case 2: return fmt::format("({}) * {}", a, literal());
            case 3: return fmt::format("vcross({}, {})", a, b);
            case 4: return fmt::format("vrotate({}, {} * 7)", a, b);
            default: return fmt::format("<{}, {}, {}>", number(depth - 1), literal(), number(depth - 1));
        }
    }

  private:
    size_t random(int n) { return size_t(std::uniform_int_distribution<int>(0, n - 1)(engine_)); }
    std::string comparison() { return std::vector<std::string>{" < ", " > ", " <= ", " >= ", " = ", " != "}[random(6)]; }
    std::string literal() {
        static const std::vector<std::string> all = {"1", "2.5", ".3", "3e-2", "7", "-1.25", "pi", "12.", "0.1", "K", "A[1]", "W.y", "true", "1.5E1"};
        return all[random(int(all.size()))];
    }
    std::mt19937 engine_{20240};
};

void ask_listed(Questions& q) {
    const std::vector<std::string> arguments = {"0", ".3", "1", "-.7", "2.5", "1e-3"};
    for (const char* f : {"abs", "asinh", "atan", "ceil", "cos", "cosh", "exp", "floor", "int", "sin", "sinh", "tan", "tanh", "degrees", "radians", "acos", "asin"})
        for (const std::string& a : arguments)
            if (!(std::string("acos asin").find(f) != std::string::npos && a == "2.5")) q.number(fmt::format("{}({})", f, a));
    for (const char* e : {"acosh(1.5)", "atanh(.5)", "atanh(-.25)", "ln(2)", "ln(1e-9)", "log(1000)", "log(3)", "sqrt(2)", "sqrt(0)", "pow(2, .5)", "pow(-2, 3)", "pow(3, -2)", "atan2(1, 2)",
                          "atan2(-1, -2)", "atan2(0, -1)", "mod(-7, 3)", "mod(1, .1)", "mod(7.5, -2)", "div(7, 2)", "div(-7, 2)", "div(7.9, 2.5)", "int(1e20)", "int(-3.9)", "min(3, 1, 2)", "max(1)",
                          "max(3, 5, 4)", "select(-1, 5, 6)", "select(0, 5, 6)", "select(0, 5, 6, 7)", "select(1e-12, 5, 6, 7)", "bitwise_and(7, 2, 3)", "bitwise_or(4294967296, 1)",
                          "bitwise_xor(7.9, -2)", "1/3", "2/3*3", "-2*-3", "1e308*10", "(1 < 1+1e-11)", "(1 = 1+1e-11)", "(1 >= 1+1e-11)", "(1 != 1+1e-11)", "!1e-11", "!1e-9", "(1|0&0)", "clock", "version",
                          "frame_number", "clock_on", "vlength(<3,4>)", "vlength(5)", "strlen(\"abc\")", "strcmp(\"a\", \"b\")", "strcmp(\"abc\", \"a\")", "strcmp(\"\", \"z\")", "val(\"12.5abc\")",
                          "val(\"-3e2\")", "val(\".5\")", "asc(\"A\")", "asc(\"\")", "dimensions(A)", "dimension_size(A, 1)", "defined(A)", "defined(Zork)", "R1", "R2", "rand(R1)", "rand(R1)",
                          "rand(R2)", "rand(R2)", "rand(R3)", "F(1, 2)", "F(F(1, 2), 3)", "FT(1, 2, 3)", "Sum(5, 100)", "Sum(0, 3)", "Sum(3.5, 0)", "Prod(2)", "Prod(-4)", "Unnamed(1, 2, 3)", "Named(2, 3)", "Texture(2, 3)", "Other(2, 3)", "Twice(2, 3)", "Same(FA[0](3))", "Same(FA[1](FA[0](2), 7) + 1)",
                          "Of(SA[0](.3))", "sin(1).x", "defined(x)", "defined(pi)", "defined(sphere)", "val(\"0x1F\")", "val(\" -0x1.8p1\")", "val(\"+7\")", "val(\"--7\")", "val(\"- 7\")", "val(\"\")",
                          "strlen(substr(\"abc\", 0, 2))", "G(1, 2, 3)", "H(2.5)", "H(-7)", "A[1-1e-10]", "A[1-2e-10]", "A[-.5e-10]",
                          "dimension_size(A, 2)", "dimension_size(A, 0)", "dimension_size(A, -1)", "Frame(2)", "K.x", "K.u*2 - K.red", "-K.x/3", "A[1].x", "Chain(1, 2, 3)", "Chain(3, 2, 1)", "Chain(1, 1, 1)"})
        q.number(e);
    for (const char* e : {"vnormalize(<1,2,3>)", "vcross(<1,2,3>, <4,5,6>)", "vrotate(<1,2,3>, <10,20,30>)", "vrotate(x, y*90)", "vaxis_rotate(x, z, 30)", "vaxis_rotate(<1,2,3>, <3,-1,2>, 77)",
                          "<1,2,3>*<4,5>", "2*y - x/3", "C", "C*2", "C + <1,2,3>", "color C filter .5", "rgb <.1,.2,.3>", "S1(.25)", "S1(-1)", "S1(9)", "S1(1.5)", "S2(.3)", "S2(1.25)", "S2(2.5)", "S3(1.1)",
                          "S3(1.9)", "S3(.5)", "S3(2.6)", "S4(.2)", "S4(1.5)", "S4(2.9)", "T1(1, 2, 3)", "T2(1, 2, 3)", "T3(1, 2, 3)", "T4(1, 2, 3)", "T5(1, 2, 3)", "T6(1, 2, 3)", "T7(1, 2, 3)", "!<1,0,-2>", "S5(0)", "S5(2)", "S5(2.5)", "S5(3)", "S5(4.5)", "S5(5)", "S6(.25)", "S6(0)", "S6(3)", "min_extent(Boxed)",
                          "max_extent(Boxed)", "min_extent(Both)", "max_extent(Both)", "(x = y)", "(<1,2,3> < 2)", "(3 != <1,2,3>)", "(<1,0,3> & <2,2,0>)", "(x | y)", "(<1,2> = <1,2,0>)", "(W >= -.25)", "K.red*<1,2,3>"})
        q.vector(e, 3);
    for (const char* e : {"rgbf .5", "rgbt .5", "rgbft .5", "rgbft <.1,.2,.3,.4,.5>", "rgbt C", "rgbt C5", "rgbt C5*2", "rgbf C5", "rgbt V5", "rgbt <.1,.2,.3>", "color red .3 green .2", "C*.5", "color <1,2,3> transmit .25", "srgb <.2,.5,.9>", "srgb .01", "srgbt <.2,.5,.9,.3>", "V5", "V5*3", "<.1,.2,.3,.4,.5>",
                          "Same(<.1,.2,.3,.4,.5>)", "S5(3.7)"})
        q.vector(e, 5);
}

void ask_strings(Questions& q) {
    for (const char* v : {"0", "1", "-1.5", "2.5", "3.5", "1/3", "-1e-9", "123456.789", "1e15"})
        for (const char* format : {"0, 0", "10, 3", "-10, 3", "0, -1", "12, -4", "3, 1", "-3, 0", "0, 20"}) q.line(fmt::format("str({}, {})", v, format), fmt::format("str({}, {})", v, format));
    for (const char* e : {"vstr(3, <1,2,3>, \",\", 0, 1)", "vstr(2, x, \" \", 6, 2)", "vstr(5, rgbf .5, \"/\", 0, 0)", "vstr(7, <1,2>, \";\", 0, 0)", "vstr(1, <1,2>, \";\", 0, 0)", "vstr(3, 2, \",\", 0, 0)",
                          "substr(\"hello\", 2, 3)", "substr(\"hello\", 5, 1)", "strupr(\"aBc1\")", "strlwr(\"aBc1\")", "chr(65)", "concat(\"a\", \"b\", str(1, 0, 0))", "concat(\"a\" \"b\", \"c\")", "datetime(0.5)", "datetime(7500.25, \"%Y/%j\")",
                          "datetime(-100)", "str(strlen(str(1e250, 0, 3)), 0, 0)", "str(1e251, 0, 3)", "str(1.23456789e300, 15, 7)", "str(-1e300, 15, -1)", "str(1, 20, 300)", "str(strlen(str(1, 254, 3)), 0, 0)", "str(1, 255, 3)", "str(val(\"1e400\"), 0, 0)"})
        q.line(std::string(e) == "vstr(5, rgbf .5, \"/\", 0, 0)" ? "vstr(5, C, \"/\", 0, 0)" : e, e);
}

void ask_turbulence(Questions& q) {
    for (const char* e : {"vturbulence(2, .5, 6, <1.2,3.4,5.6>)", "vturbulence(3, .4, 0, <1.2,3.4,5.6>)", "vturbulence(3, .4, 12, <1.2,3.4,5.6>)", "vturbulence(3, .4, 2.7, <1.2,3.4,5.6>)", "vturbulence(3 .4, -3 <-1.2,-3.4,-5>)",
                          "vturbulence(0, -1, 3, 1.5)", "vturbulence(2.13, .61, 5, <-7.125, 0, 40.5>)", "vturbulence(2, .5, 1, <0,0,17>)", "vturbulence(1.9, 1.1, 9, <.01,.02,-.03>) + x"})
        q.vector(e, 3);
}

Questions questions() {
    Questions q;
    q.prelude = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare K = 1.75;\n#declare A = array[2] {2, .6}\n#declare W = <.5, -.25, 4>;\n#declare C = rgb <.1, .7, .2>;\n#declare C5 = rgbft <.1, .7, .2, .3, .4>;\n"
                "#declare R1 = seed(123);\n#declare R2 = seed(-5.7);\n#declare R3 = seed(4294967295);\n"
                "#declare F = function(a, b) { a*2 + b*b/3 - sin(a) }\n#declare G = function { (x > 1) + y*z - mod(z, 2) + F(x, K) }\n#declare H = function(x) { select(mod(x, 2), 1, 0, 1) + (x >= 2)*floor(x) }\n"
                "#declare S1 = spline { linear_spline 0, <0,0,0> 1, <1,2,3> 2, <-1,5,2> }\n#declare S2 = spline { quadratic_spline 0, <0,0,0> 1, <1,2,3> 2.5, <-1,5,2> 3, <0,1,0> }\n"
                "#declare S3 = spline { cubic_spline 0, <0,0,0> 1, <1,2,3> 2.5, <-1,5,2> 3, <0,1,0> }\n#declare S4 = spline { natural_spline 0, <0,0,0> 1, <1,2,3> 2.5, <-1,5,2> 3, <0,1,0> }\n";
    q.prelude += "#declare T = transform { rotate <10,20,30> scale <1,2,3> translate <4,5,6> }\n#declare T1 = function { transform { T } }\n#declare T2 = function { transform { T inverse } }\n"
                 "#declare T3 = function { transform { matrix <1,2,3, 0,1,0, 1,0,1, 5,6,7> } }\n#declare T4 = function { transform { T scale 2 inverse translate x } }\n"
                 "#declare T5 = function { transform { transform { T } rotate 90*y } }\n#declare T6 = function { transform { scale <0,2,1> } }\n"
                 "#declare T7 = function { transform { matrix <1,0,.5, .2,0,.3, 0,0,1, 0,0,0> } }\n#declare FT = function(x, y, z) { T1(x, y, z).y + T5(y, z, x).z }\n";
    q.prelude += "#declare S6 = spline { cubic_spline 0, x 1, <3,1,2> }\n#declare Chain = function(a, b, c) { (a < b < c) + 10*(a = b = c) }\n#declare Frame = function(q) { q*2 + frame_number + clock_delta + initial_clock + final_clock }\n";
    q.prelude += "#declare S5 = spline { linear_spline 0, 1 1, <1,2,3> 2, 9 3, 5 4, <1,2,3,4,5> 5, <6,7> }\n#declare FA = array[2] {function(x) { x*2 }, function(x, y) { x - y }}\n#declare SA = array[1]\n#declare SA[0] = S4;\n"
                 "#declare Sum = function(n, i) { sum(i, 1, n, i*i) + i }\n#declare Prod = function(n) { prod(k, n, n + 2, sum(j, 1, k, j*k)) }\n#declare Unnamed = function { u*100 + v*10 + x + y + z }\n"
                 "#declare Named = function(y, x) { u + 10*v + z }\n#declare Texture = function(u, v) { x - y/3 }\n#declare Other = function(a, x) { u + v + a }\n#declare Twice = function(u, x) { u + 10*x }\n"
                 "#declare Boxed = box { -1, 1 scale 1.1 }\n#declare Both = union { sphere { .1, .7 } triangle { <.1,.2,.3>, <.4,.7,.9>, <1.1,2.2,3.3> } }\n#declare V5 = <.1,.2,.3,.4,.5>*.3;\n#macro Same(a) a #end\n#macro Of(a) a.y #end\n";
    ask_listed(q);
    ask_strings(q);
    ask_turbulence(q);
    Generator generate;
    for (int i = 0; i < 200; ++i) q.number(generate.number(1 + i % 3));
    for (int i = 0; i < 60; ++i) q.vector(generate.vector(1 + i % 3), 3);
    return q;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

bool same(const std::string& ours, const std::string& theirs) {
    if (ours == theirs) return true;
    char *end_a = nullptr, *end_b = nullptr;
    const double a = std::strtod(ours.c_str(), &end_a), b = std::strtod(theirs.c_str(), &end_b);
    return !*end_a && !*end_b && !ours.empty() && !theirs.empty() && std::fabs(a - b) <= 2e-15 * std::max(1.0, std::fabs(b));
}

}  // namespace

TEST(PovDifferential, ExpressionsHaveThePovRaysOwnValues) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const Questions q = questions();
    ASSERT_GT(q.asked.size(), 500u);
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    Diagnostics said;
    read_program_text("scene.pov", q.prelude + q.text, options, said);
    ASSERT_FALSE(said.has_errors()) << said.text();
    const std::vector<std::string> ours = lines_of(printed), theirs = lines_of(povray_debug(q.prelude + q.text));
    ASSERT_EQ(ours.size(), q.asked.size());
    ASSERT_EQ(theirs.size(), q.asked.size());
    for (size_t i = 0; i < ours.size(); ++i) EXPECT_TRUE(same(ours[i], theirs[i])) << q.asked[i] << ": " << ours[i] << ", POV-Ray has " << theirs[i];
    RecordProperty("values", int(ours.size()));
}

// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's reserved words, and numbers for every name.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace alidade::pov {

using WordId = uint32_t;

/// POV-Ray 3.7 reference, 3.3.1.2 "Keywords", sorted. (What is listed there and POV-Ray lets scenes declare is a name: `atand`, and what predeclare() gives.)
inline constexpr std::string_view kWords[] = {
    "aa_level", "aa_threshold", "abs", "absorption", "accuracy", "acos", "acosh", "adaptive", "adc_bailout", "agate", "agate_turb", "albedo", "all",
    "all_intersections", "alpha", "altitude", "always_sample", "ambient", "ambient_light", "angle", "aoi", "aperture", "append", "arc_angle",
    "area_illumination", "area_light", "array", "asc", "ascii", "asin", "asinh", "assumed_gamma", "atan", "atan2", "atanh", "autostop", "average",
    "b_spline", "background", "bezier_spline", "bicubic_patch", "bitwise_and", "bitwise_or", "bitwise_xor", "black_hole", "blob", "blue",
    "blur_samples", "bmp", "bokeh", "bounded_by", "box", "boxed", "bozo", "break", "brick", "brick_size", "brightness", "brilliance", "bump_map",
    "bump_size", "bumps", "camera", "case", "caustics", "ceil", "cells", "charset", "checker", "chr", "circular", "clipped_by", "clock",
    "clock_on", "collect", "color", "color_map", "colour", "colour_map", "component", "composite", "concat", "cone", "confidence",
    "conic_sweep", "conserve_energy", "contained_by", "control0", "control1", "coords", "cos", "cosh", "count", "crackle", "crand", "cube", "cubic",
    "cubic_spline", "cubic_wave", "cutaway_textures", "cylinder", "cylindrical", "datetime", "debug", "declare", "default", "defined", "degrees",
    "density", "density_file", "density_map", "dents", "deprecated", "df3", "difference", "diffuse", "dimension_size", "dimensions", "direction",
    "disc", "dispersion", "dispersion_samples", "dist_exp", "distance", "div", "double_illuminate", "eccentricity", "else", "elseif", "emission",
    "end", "error", "error_bound", "evaluate", "exp", "expand_thresholds", "exponent", "exr", "exterior", "extinction", "face_indices", "facets",
    "fade_color", "fade_colour", "fade_distance", "fade_power", "falloff", "falloff_angle", "false", "fclose", "file_exists", "filter",
    "finish", "fisheye", "flatness", "flip", "floor", "focal_point", "fog", "fog_alt", "fog_offset", "fog_type", "fopen", "for",
    "form", "frequency", "fresnel", "function", "gamma", "gather", "gif", "global_lights", "global_settings", "gradient", "granite",
    "gray", "gray_threshold", "green", "hdr", "height_field", "hexagon", "hf_gray_16", "hierarchy", "hollow", "hypercomplex", "if", "ifdef", "iff",
    "ifndef", "image_map", "image_pattern", "importance", "include",
    "inside", "inside_vector", "int", "interior", "interior_texture", "internal", "interpolate", "intersection", "intervals",
    "inverse", "ior", "irid", "irid_wavelength", "isosurface", "jitter", "jpeg", "julia", "julia_fractal", "lambda", "lathe", "leopard",
    "light_group", "light_source", "linear_spline", "linear_sweep", "ln", "load_file", "local", "location", "log", "look_at", "looks_like",
    "low_error_factor", "macro", "magnet", "major_radius", "mandel", "map_type", "marble", "material", "material_map", "matrix", "max", "max_extent",
    "max_gradient", "max_intersections", "max_iteration", "max_sample", "max_trace", "max_trace_level", "maximum_reuse", "media", "media_attenuation",
    "media_interaction", "merge", "mesh", "mesh2", "mesh_camera", "metallic", "method", "metric", "min", "min_extent", "minimum_reuse", "mm_per_unit",
    "mod", "mortar", "natural_spline", "nearest_count", "no", "no_bump_scale", "no_image", "no_radiosity", "no_reflection", "no_shadow",
    "noise_generator", "normal", "normal_indices", "normal_map", "normal_vectors", "now", "number_of_sides", "number_of_tiles", "number_of_waves", "object", "octaves", "off", "offset",
    "omega", "omnimax", "on", "once", "onion", "open", "orient", "orientation", "orthographic", "ovus", "panoramic", "parallel", "parametric",
    "pass_through", "pattern", "pavement", "perspective", "pgm", "phase", "phong", "phong_size", "photons", "pi", "pigment", "pigment_map",
    "pigment_pattern", "planar", "plane", "png", "point_at", "poly", "poly_wave", "polygon", "polynomial", "pot", "potential", "pow", "ppm",
    "precision", "precompute", "premultiplied", "pretrace_end", "pretrace_start", "prism", "prod", "projected_through", "pwr", "quadratic_spline",
    "quadric", "quartic", "quaternion", "quick_color", "quick_colour", "quilted", "radial", "radians", "radiosity", "radius", "rainbow", "ramp_wave",
    "rand", "range", "ratio", "read", "reciprocal", "recursion_limit", "red", "reflection", "reflection_exponent", "refraction", "render", "repeat",
    "rgb", "rgbf", "rgbft", "rgbt", "right", "ripples", "rotate", "roughness", "samples", "save_file", "scale", "scallop_wave", "scattering", "seed",
    "select", "shadowless", "sin", "sine_wave", "sinh", "sint16be", "sint16le", "sint32be", "sint32le", "sint8", "size", "sky", "sky_sphere", "slice",
    "slope", "slope_map", "smooth", "smooth_triangle", "solid", "sor", "spacing", "specular", "sphere", "sphere_sweep", "spherical", "spiral1",
    "spiral2", "spline", "split_union", "spotlight", "spotted", "sqr", "sqrt", "square", "srgb", "srgbf", "srgbft", "srgbt", "statistics", "str",
    "strcmp", "strength", "strlen", "strlwr", "strupr", "sturm", "substr", "subsurface", "sum", "superellipsoid", "switch", "sys", "t", "tan", "tanh",
    "target", "text", "texture", "texture_list", "texture_map", "tga", "thickness", "threshold", "tiff", "tightness", "tile2", "tiles", "tiling",
    "tolerance", "toroidal", "torus", "trace", "transform", "translate", "translucency", "transmit", "triangle", "triangle_wave", "triangular",
    "true", "ttf", "turb_depth", "turbulence", "type", "u", "u_steps", "uint16be", "uint16le", "uint8", "ultra_wide_angle", "undef", "union", "up",
    "use_alpha", "use_color", "use_colour", "use_index", "utf8", "uv_indices", "uv_mapping", "uv_vectors", "v", "v_steps", "val", "variance",
    "vaxis_rotate", "vcross", "vdot", "version", "vertex_vectors", "vlength", "vnormalize", "vrotate", "vstr", "vturbulence", "warning", "warp",
    "water_level", "waves", "while", "width", "wood", "wrinkles", "write", "x", "y", "yes", "z"};
inline constexpr WordId kWordCount = std::size(kWords);
static_assert(std::is_sorted(std::begin(kWords), std::end(kWords)));

/// The number of a reserved word, in a constant expression: `case "sphere"_w:`. A word that is not reserved does not compile.
consteval WordId operator""_w(const char* text, size_t length) {
    const std::string_view word(text, length);
    const auto* at = std::lower_bound(std::begin(kWords), std::end(kWords), word);
    if (at == std::end(kWords) || *at != word) throw std::logic_error("not a reserved word");
    return WordId(at - std::begin(kWords));
}

/// FNV-1a, letter by letter, so that the lexer hashes a name while it looks for its end.
class NameHash {
  public:
    void add(char c) { hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 16777619u; }
    uint32_t value() const { return hash_ ^ hash_ >> 15; }

  private:
    uint32_t hash_ = 2166136261u;
};

/// Names of a scene as numbers: the reserved words first, then identifiers as they are met.
class Names {
  public:
    Names();
    WordId id(std::string_view name) { return id(name, hash_of(name)); }
    /// `hash` is that of the name.
    WordId id(std::string_view name, uint32_t hash);
    std::string_view text(WordId id) const { return texts_[id]; }
    size_t size() const { return texts_.size(); }
    /// The name nearest to `name` by edit distance (at most a third of its length) among those that `admit`s, or "". Those that go on behind it with a _ come before
    /// all others, the last of them first: light_source, not light_group, for light.
    template <class Admit>
    std::string_view nearest(std::string_view name, Admit admit) const;

  private:
    static constexpr WordId kFree = ~WordId(0);
    struct Entry {
        uint32_t hash = 0;
        WordId id = kFree;
    };
    static uint32_t hash_of(std::string_view name);
    void rehash(size_t size);
    /// Where an entry of this hash stands, or the free place behind those that it could be; `same` tells whether it is the one.
    template <class Same>
    Entry& place_of(uint32_t hash, Same same);

    std::vector<std::string_view> texts_;
    std::deque<std::string> identifiers_;   ///< what texts_ points to behind the reserved words
    std::vector<Entry> table_;              ///< a power of two of places, at most half of them taken: a name stands at its hash or behind; asked for every name of a file
};

/// Is #word one?
bool is_directive(WordId id);

/// Does the block of this word hold an object (or a light)? Also those that are not modelled yet.
bool is_object(WordId word);

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`, letters without case.
size_t edit_distance(std::string_view a, std::string_view b);

template <class Admit>
std::string_view Names::nearest(std::string_view name, Admit admit) const {
    std::string_view best;
    size_t least = std::max<size_t>(1, name.size() / 3) + 1;
    for (WordId id = 0; id < texts_.size(); ++id) {
        const size_t difference = texts_[id].size() > name.size() ? texts_[id].size() - name.size() : name.size() - texts_[id].size();
        const bool goes_on = texts_[id].size() > name.size() && texts_[id][name.size()] == '_' && texts_[id].starts_with(name);
        if ((difference >= least && !goes_on) || texts_[id] == name || !admit(id)) continue;
        if (goes_on) least = 0, best = texts_[id];
        else if (const size_t d = edit_distance(name, texts_[id]); d < least) least = d, best = texts_[id];
    }
    return best;
}

}  // namespace alidade::pov

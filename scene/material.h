// SPDX-License-Identifier: Apache-2.0
/// What surfaces and interiors are made of: a graph of signals shared by two families of surfaces.
#pragma once

#include "core/source.h"
#include "core/transform.h"
#include "scene/ids.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace alidade {

/// A picture, still encoded as the file holds it: decoded by compile(), and only if a used material reads it.
struct Image {
    std::string name;
    std::string path;                 ///< of a file to read, resolved and allowed by the importer; or
    std::vector<std::byte> bytes;     ///< the encoded file itself (GLB, data: URI)
    SourcePos from;
};

// ---- Signals: functions of a surface point (and its texture coordinates) with up to four channels ----

struct ConstantSignal {
    Vec4 value{0, 0, 0, 1};
    double filter = 0, transmit = 0;   ///< of a POV-Ray colour: its fourth and fifth number, beside alpha
};

enum class Wrap { repeat, clamp, mirror, once };
enum class Filter { nearest, linear };

/// An image looked up at texture coordinates.
struct ImageSignal {
    ImageId image;
    uint32_t uv_set = 0;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    Filter filter = Filter::linear;
    bool srgb = false;        ///< colour channels are sRGB-encoded; alpha never is
    Mat3 uv_transform{1.0};   ///< applied to (u, v, 1)
};

/// Component by component.
struct ProductSignal {
    SignalId a, b;
};

/// One channel (0..3) of another signal, in all four.
struct ChannelSignal {
    SignalId of;
    int channel = 0;
};

/// A map entry: at `value` of the pattern stands `signal`.
struct MapEntry {
    double value = 0;
    SignalId signal;
};

enum class WarpKind { transform, turbulence, black_hole, repeat, planar, cylindrical, spherical, toroidal, cubic };

/// A distortion of the point before a pattern is looked up (POV-Ray's manual, 3.4.7.7 "Warps"). `parameters` by kind; what is left out at the end is POV-Ray's default:
///   turbulence   amount x y z, octaves, omega, lambda
///   black_hole   centre x y z, radius, strength, falloff, inverse (0 or 1), repeat x y z, turbulence x y z
///   repeat       width along one axis x y z (two are 0), offset x y z, flip x y z
///   planar       orientation x y z, distance
///   cylindrical, spherical   orientation x y z, dist_exp
///   toroidal     orientation x y z, dist_exp, major radius
struct Warp {
    WarpKind kind = WarpKind::transform;
    Transform transform;
    std::vector<double> parameters;
};

/// POV-Ray's `noise_generator` 1, 2, 3.
enum class NoiseGenerator { original = 1, range_corrected = 2, perlin = 3 };

/// How octaves of noise are added up, and by how much they move a point.
struct Turbulence {
    Vec3 amount{0};
    int octaves = 6;
    double omega = 0.5, lambda = 2;
};

enum class Wave { ramp, sine, triangle, scallop, cubic, poly };

/// How POV-Ray lays a picture out in space (its `map_type` 0, 1, 2, 5): on the plane z = 0 from <0, 0> to <1, 1>; around the y axis as on a sphere, a cylinder of
/// height 1 or a torus of major radius 1.
enum class PictureMap { planar, spherical, cylindrical, toroidal };
/// Between pixels (`interpolate`: none, 2, 3, 4): `distance` weighs the four nearest by 1 / distance^2.
enum class PictureFilter { none, bilinear, bicubic, distance };
/// What a picture's stored numbers are: `told` is what the file says by itself, and where it does not, what stands behind the word.
enum class PictureCode { stored, told_or_srgb, told_or_stored, srgb, power };
/// Which of a picture's numbers make a pattern. `transmission`: what passes, red without alpha. `palette`: the number of a colour there; without one, the grey.
/// `number`: the same, but red times 255 without a palette.
enum class PictureValue { grey, transmission, palette, number };

/// The pattern whose colours are a picture's, without a map.
inline constexpr const char* kImageMap = "image_map";
/// The pattern whose number is a function's.
inline constexpr const char* kFunctionPattern = "function";

/// A picture in space, of the patterns that show one (POV-Ray's manual, 3.4.7.6 "Image Map").
struct PatternPicture {
    ImageId image;
    PictureMap map = PictureMap::planar;
    PictureFilter filter = PictureFilter::none;
    PictureCode code = PictureCode::stored;
    double gamma = 1;                 ///< of PictureCode::power: linear = stored ^ gamma
    bool scene_gamma = true;          ///< what was decoded becomes what the scene calculates with (RenderSettings::assumed_gamma); false: it stays linear
    bool once = false;                ///< it is not repeated: nothing is around it
    bool premultiplied = false;       ///< the file's colours are multiplied by its alpha
    PictureValue value = PictureValue::grey;
    /// What passes colours: the one with a number in the palette, or all. Of palettes it takes the place of the alpha, of others transmit is added to it.
    /// The last that is said of a colour holds.
    struct Clearing {
        std::optional<int> color;
        std::optional<double> filter, transmit;
        friend bool operator==(const Clearing&, const Clearing&) = default;
    };
    std::vector<Clearing> clearings;

    friend bool operator==(const PatternPicture&, const PatternPicture&) = default;
};

/// A pattern of the point (a name in the pattern registry, eval/patterns/registry.h) mapped to signals.
struct PatternSignal {
    std::string pattern;
    std::vector<double> parameters;        ///< in the order of the pattern's row; what is left out at the end has the row's default
    std::optional<SignalId> source;        ///< of `pigment_pattern`: the pigment whose grey is the pattern's number
    std::optional<FunctionId> function;    ///< of `function`: what is the pattern's number, of (x, y, z)
    std::optional<PatternPicture> picture; ///< of `image_map`, `image_pattern` and `bump_map`, and of nothing else
    bool uv_mapped = false;                ///< looked up at (u, v, 0) of the surface (v upwards), and not at the point
    bool bumps_turn = false;               ///< of reliefs and maps of textures that are uv_mapped: the bumps' directions follow the object; false: they are those of the world
    Mat3 bumps_turned{1.0};                ///< the linear map that those directions went through with the texture
    std::vector<MapEntry> map;             ///< in the order of the file, which is not sorted; of `average`, the values are weights
    std::vector<Warp> warps;               ///< in the order of the file: the last is undone first
    Turbulence turbulence;                 ///< the `turbulence` outside of warps: applied after all of them
    NoiseGenerator noise = NoiseGenerator::range_corrected;
    std::optional<Wave> wave;              ///< absent: the pattern's own
    double wave_exponent = 1;              ///< of Wave::poly
    std::optional<double> frequency;       ///< absent: the pattern's own, 1 or 0
    double phase = 0;
};

/// At `value` of a pattern, the height of a relief and its slope there.
struct SlopeEntry {
    double value = 0, height = 0, slope = 0;
};

/// POV-Ray's normal: the surface is shaded as if `pattern` were a relief on it. The entries of the pattern's map, if it has one, are reliefs as well: their normals are mixed.
struct ReliefSignal {
    PatternSignal pattern;
    double amount = 0.5;              ///< how deep it is (`bump_size`)
    double accuracy = 0.02;           ///< how far apart the pattern is looked up for its slope
    bool scaled = true;               ///< the depth is the same however the pattern is scaled; false: no_bump_scale
    std::vector<SlopeEntry> slopes;   ///< in the order of the file; empty: the pattern's value is the height. Patterns with a relief of their own have no use for them
};

struct Signal {
    std::variant<ConstantSignal, ImageSignal, ProductSignal, ChannelSignal, PatternSignal, ReliefSignal> what;
    SourcePos from;
};

// ---- Surfaces ----

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0 metal-rough (section 3.9 and appendix B), with the ratified extensions that a ray tracer can model.
struct GltfPbr {
    SignalId base_color;                      ///< RGBA; the mesh's vertex colour multiplies it
    std::optional<SignalId> metallic, roughness;   ///< one channel each; absent: 1
    std::optional<SignalId> normal;           ///< tangent space, encoded in 0..1
    double normal_scale = 1;
    std::optional<SignalId> occlusion;        ///< kept for exporters; a ray tracer finds its own occlusion
    std::optional<SignalId> emissive;
    double emissive_strength = 1;             ///< KHR_materials_emissive_strength
    AlphaMode alpha_mode = AlphaMode::opaque;
    double alpha_cutoff = 0.5;
    bool double_sided = false;
    bool unlit = false;                       ///< KHR_materials_unlit
    double ior = 1.5;                         ///< KHR_materials_ior
    std::optional<SignalId> transmission;     ///< KHR_materials_transmission; absent: 0
    std::optional<SignalId> specular, specular_color;                        ///< KHR_materials_specular
    std::optional<SignalId> clearcoat, clearcoat_roughness, clearcoat_normal;   ///< KHR_materials_clearcoat
};

/// POV-Ray's finish (manual, 3.4.3 "Finish"), with its pigment and normal.
struct PovFinish {
    SignalId pigment;                         ///< RGB, filter, transmit
    std::optional<SignalId> normal;           ///< a ReliefSignal
    Color ambient{0.1}, emission{0};
    double diffuse = 0.6, brilliance = 1, diffuse_back = 0;
    double phong = 0, phong_size = 40, specular = 0, roughness = 0.05, metallic = 0, crand = 0;
    Color reflection_min{0}, reflection_max{0};
    double reflection_falloff = 1, reflection_exponent = 1, reflection_metallic = 0;
    bool reflection_fresnel = false, conserve_energy = false;
    double irid = 0, irid_thickness = 0, irid_turbulence = 0;   ///< colours of a thin film
    std::optional<double> ior, caustics;      ///< before POV-Ray 3.1: what a finish said of the interior. Whoever reads a scene has put it there; it is kept for those who write one
    double refraction = 1;                    ///< likewise
    bool uncolored = false;                   ///< of all colours filter + transmit pass alike: POV-Ray 3.1 and before, of all layers but the lowest
};

/// POV-Ray's texture_map, and a list of textures: where `pattern` (a PatternSignal) has a value, the light of the textures beside it in the map is mixed. The signals of the map itself are not read.
struct PovTextureMap {
    SignalId pattern;
    std::vector<MaterialId> textures;         ///< one an entry of the map
};

/// Layers from the bottom up; glTF materials and plain POV textures have one.
struct Material {
    std::string name;
    std::vector<std::variant<GltfPbr, PovFinish, PovTextureMap>> layers;
    SourcePos from;
};

/// What fills a solid.
struct Interior {
    double ior = 1, dispersion = 1;
    int dispersion_samples = 7;
    double caustics = 0;
    double refraction = 1;                 ///< before POV-Ray 3.1: what passes the surface is multiplied by it, but in shadows
    double fade_distance = 0, fade_power = 0;
    Color fade_color{0};
    Color attenuation_color{1};            ///< KHR_materials_volume: the colour that white becomes ...
    double attenuation_distance = kInf;    ///< ... after this distance
    struct Medium {
        Color absorption{0}, emission{0}, scattering{0};
        int scattering_type = 1;
        double eccentricity = 0, extinction = 1;
        std::vector<SignalId> density;
    };
    std::vector<Medium> media;
    SourcePos from;
};

}  // namespace alidade

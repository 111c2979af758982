// SPDX-License-Identifier: Apache-2.0
/// The scene graph: what the file says, as plain values and indices. No pointers, no virtual functions; copyable, comparable by dump().
#pragma once

#include "scene/animation.h"
#include "scene/camera.h"
#include "scene/function.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/shape.h"

#include <map>

namespace alidade {

enum class CsgKind { none, union_, merge, intersection, difference };   ///< of a node's children

struct NodeFlags {
    bool visible = true;        ///< KHR_node_visibility: false hides the node and all below
    bool shadow = true;         ///< POV no_shadow
    bool image = true;          ///< POV no_image
    bool reflection = true;     ///< POV no_reflection
    bool hollow = false;
    bool double_illuminate = false;
    /// POV uv_mapping, also of all below: whatever texture a surface shows, its patterns are looked up as if the surface's (u, v, 0) were the point in the world. Not where an
    /// inside_material reaches the shape.
    bool uv_mapping = false;
};

struct Nothing {};

/// A node of an acyclic graph; one with several parents is an instance. Materials and interior are inherited from the nearest ancestor that
/// carries one, and are evaluated in the space of the node that carries them.
struct Node {
    std::string name;
    Transform to_parent;
    std::optional<Trs> trs;                   ///< where the file gives it: to_parent is made from it, and animations change it
    std::variant<Nothing, ShapeId, LightId, CameraId> what;
    std::vector<std::optional<MaterialId>> materials;   ///< by the shape's material slot; a slot without one takes the default
    std::optional<MaterialId> inside_material;   ///< of all slots, where they are seen from inside; inherited by itself
    std::optional<InteriorId> interior;
    CsgKind csg = CsgKind::none;
    bool inverse = false;
    bool whole = false;                       ///< POV: this union is not split: of the flags of its parts, that reflections miss them counts alone
    bool cutaway_textures = false;            ///< POV: parts of this intersection or difference without a material show those of the parts that they cut
    bool usual_material = false;              ///< POV: materials[0] is that of #default, which stands where nothing else does
    std::vector<NodeId> children, clips, bounds;   ///< clips: POV clipped_by; bounds: POV bounded_by
    NodeFlags flags;
    std::vector<LightId> light_group;         ///< POV light_group: these lights shine on this node's subtree alone
    bool global_lights = true;                ///< POV global_lights: lights that are in no group shine on it, too
    bool open_light_group = false;            ///< POV: what stands in this group directly is lit by the next group around, too
    std::optional<SkinId> skin;
    std::vector<double> morph_weights;        ///< empty: the mesh's own
    SourcePos from;
};

/// POV-Ray's fog (manual, 3.4.5.3 "Fog"): everywhere, or (ground) thinning out above `offset` along `up`, to a quarter at `altitude` above it.
struct Fog {
    bool ground = false;
    double distance = 0, offset = 0, altitude = 0;
    std::optional<Turbulence> turbulence;     ///< also one of 0 makes way shorter: it shifts nothing, but the noise is not 0
    double turbulence_depth = 0.5;
    Color color{0};
    double filter = 0, transmit = 0;
    Vec3 up{0, 1, 0};
};

/// POV-Ray's rainbow: a bow of colours around the point opposite of the sun.
struct Rainbow {
    static constexpr double kWhole = 360 * 180 / kPi;   ///< degrees; what POV-Ray takes where nothing is said
    Vec3 direction{0, 0, 1};            ///< of the sun's light
    Vec3 up{0, 1, 0};                   ///< where the middle of the bow is
    double angle = 0, width = 0;        ///< degrees: the middle of its colours, from `direction`, and how far they reach from the first to the last
    double arc_angle = kWhole;          ///< degrees, around `direction`: what is seen of the bow
    double falloff_angle = kWhole;      ///< beyond it, it fades towards the ends of the arc
    double distance = 0;                ///< as a fog's; 0: it hides all
    std::optional<SignalId> colors;     ///< a pattern, looked up at <0 .. 1, 0, 0>
};

/// POV-Ray's sky_sphere: pigments looked up in the direction of a ray, the last in front.
struct SkySphere {
    std::vector<SignalId> pigments;
    Color emission{1};
    Transform transform;
};

/// What surrounds everything.
struct Atmosphere {
    Color background{0};
    Color background_mirrored{0};             ///< instead, where pictures have alpha: in mirrors,
    Color background_over{0};                 ///< by itself, over what shows through it,
    double background_shows = 1;              ///< and how much of that does
    std::optional<Color> environment;         ///< a constant sky: it lights, and is seen
    std::optional<ImageId> environment_image;   ///< equirectangular
    double environment_strength = 1;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::optional<SkySphere> sky;
    std::vector<Interior::Medium> media;

    /// Is there anything between surfaces that is neither in a solid nor a medium?
    bool is_hazy() const { return !fogs.empty() || !rainbows.empty(); }
};

enum class LightUnits { radiometric, photometric };   ///< photometric: candela and lux, 683 lm/W

/// What is seen through the surfaces of a POV scene. Shadows are coloured whatever is seen.
enum class SeeThrough {
    all,
    black,    ///< nothing: a surface shows its own share alone
    opaque    ///< and of the last layer that is reached, that colour alone, as if it let nothing pass
};

/// How well the mean of a pixel's samples through a lens must be known (POV-Ray's words).
struct LensNoise {
    double variance = 1e-4;                   ///< of the mean, in squares of the colours that are calculated with
    double confidence = 0.9;                  ///< the probability, in (0, 1), that it is below
    int fewest = 0;                           ///< samples that are taken in any case
};

/// What the file asks of the renderer; the command line has the last word.
struct RenderSettings {
    std::optional<int> max_depth;             ///< POV max_trace_level
    double adc_bailout = 1.0 / 255;
    Color ambient_light{1};
    NoiseGenerator noise = NoiseGenerator::range_corrected;   ///< of the turbulence of fogs and thin films, and of patterns that a POV-Ray file gives none
    Color irid_wavelength{0.7, 0.52, 0.48};   ///< of red, green and blue, in units of PovFinish::irid_thickness
    double assumed_gamma = 1;                 ///< colours are powers: linear = colour ^ assumed_gamma
    bool srgb_coded = false;                  ///< instead, colours are sRGB-coded: they are calculated with as they are, and decoded at the end
    bool filter_dims_by_colour = false;       ///< POV before 3.7: a filter f of a colour c takes f max(c) of the opacity, not f
    SeeThrough see_through = SeeThrough::all;
    bool follows_mirrors = true;              ///< of POV scenes: what mirrors show is seen. What they take of the light behind them is lost in any case
    bool first_box_shows = false;             ///< POV scenes: of surfaces that coincide, that of the object whose box a ray enters first is seen, of one without an end before all; but of two objects without a light the first
    double shadow_clearance = 0;              ///< what is nearer than this, along a shadow ray, behind its beginning or the last surface that let light through, is not met (POV-Ray: 0.001); world units
    bool default_light = true;                ///< a scene without light gets a sky and a sun
    LightUnits light_units = LightUnits::radiometric;
    std::string why_light_units;
    int default_spp = 16;                     ///< POV scenes: 1, the pixel's centre
    std::optional<LensNoise> lens_noise;      ///< with it, pixels may take fewer samples than default_spp
    std::string generator;                    ///< what wrote the file
};

struct Scene {
    std::vector<Node> nodes;
    std::vector<NodeId> roots;                ///< of the chosen scene
    std::vector<ShapeEntry> shapes;
    std::vector<Signal> signals;
    std::vector<Material> materials;
    std::vector<Interior> interiors;
    std::vector<Image> images;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<FunctionProgram> functions;
    Atmosphere atmosphere;
    RenderSettings settings;
    std::vector<SourceFile> files;
};

}  // namespace alidade

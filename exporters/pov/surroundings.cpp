// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/surroundings.h"

#include "exporters/pov/warps.h"

namespace alidade::pov_export {

namespace {

constexpr int kUsualDepth = 8;   ///< of a scene that says nothing

void write_sky(const SkySphere& sky, Sdl& sdl, TextureWriter& textures) {
    sdl.begin("sky_sphere");
    for (const SignalId pigment : sky.pigments) textures.patterns().pigment_block(pigment);
    if (sky.emission != Color(1)) sdl.line("emission", Expression{sky.emission});
    if (!sky.transform.is_identity()) sdl.line(sky.transform);
    sdl.end();
}

void write_fog(const Fog& fog, Sdl& sdl) {
    sdl.begin("fog");
    sdl.line("fog_type", fog.ground ? 2 : 1, "distance", fog.distance);
    sdl.line(Rgbft{fog.color, fog.filter, fog.transmit});
    if (fog.ground) sdl.line("fog_offset", fog.offset, "fog_alt", fog.altitude, "up", fog.up);
    if (fog.turbulence) {
        if (fog.turbulence->amount == Vec3(0)) sdl.line("turbulence 0");
        write_turbulence(sdl, *fog.turbulence);
        sdl.line("turb_depth", fog.turbulence_depth);
    }
    sdl.end();
}

void write_rainbow(const Scene& scene, const Rainbow& bow, Sdl& sdl, TextureWriter& textures, Losses& losses) {
    const auto* colors = bow.colors ? std::get_if<PatternSignal>(&scene.signals[bow.colors->index].what) : nullptr;
    losses.add("rainbows whose colours are no map of colours", bow.colors && !colors, "nothing");
    if (!colors) return;
    sdl.begin("rainbow");
    sdl.line("direction", bow.direction, "up", bow.up);
    sdl.line("angle", bow.angle, "width", bow.width, "distance", bow.distance);
    if (bow.arc_angle != Rainbow::kWhole) sdl.line("arc_angle", bow.arc_angle);
    if (bow.falloff_angle != Rainbow::kWhole) sdl.line("falloff_angle", bow.falloff_angle);
    textures.patterns().pigment_map(*colors);
    sdl.end();
}

/// POV-Ray takes columns from +x towards +z; the scene's picture has +x in its middle.
void write_environment_picture(const Scene& scene, Sdl& sdl, ImageWriter& images) {
    const Atmosphere& a = scene.atmosphere;
    sdl.begin("sky_sphere");
    sdl.begin("pigment");
    if (!images.sky(*a.environment_image)) sdl.line("color rgb 0");
    sdl.line("rotate <0,180,0>");
    sdl.end();
    if (a.environment_strength != 1) sdl.line("emission", a.environment_strength);
    sdl.end();
}

bool has_vertex_colors(const Scene& scene) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const auto& shape) {
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        return mesh && !mesh->colors.empty();
    });
}

}  // namespace

void write_settings(const Scene& scene, Sdl& sdl) {
    const RenderSettings& s = scene.settings;
    sdl.line(version_line(scene));
    sdl.begin("global_settings");
    if (s.srgb_coded) sdl.line("assumed_gamma srgb");   // numbers are calculated with as they are, and decoded at the end
    else sdl.line("assumed_gamma", s.assumed_gamma);
    sdl.line("max_trace_level", std::clamp(s.max_depth.value_or(kUsualDepth) + 1, 1, 256));
    sdl.line("adc_bailout", has_vertex_colors(scene) ? 0.0 : s.adc_bailout);   // corners whose share is below it would be left out
    if (s.ambient_light != Color(1)) sdl.line("ambient_light", Expression{s.ambient_light});
    if (s.irid_wavelength != RenderSettings().irid_wavelength) sdl.line("irid_wavelength", Expression{s.irid_wavelength});
    if (s.noise != RenderSettings().noise) sdl.line("noise_generator", int(s.noise));
    if (number_of_waves(scene) != 10) sdl.line("number_of_waves", number_of_waves(scene));
    sdl.end();
}

std::vector<SignalId> pigments_of_surroundings(const Scene& scene) {
    std::vector<SignalId> out;
    if (scene.atmosphere.sky) out = scene.atmosphere.sky->pigments;
    for (const Rainbow& bow : scene.atmosphere.rainbows)
        if (bow.colors) out.push_back(*bow.colors);
    const auto add = [&](const std::vector<Interior::Medium>& media) {
        for (const Interior::Medium& m : media) out.insert(out.end(), m.density.begin(), m.density.end());
    };
    add(scene.atmosphere.media);
    for (const Interior& in : scene.interiors) add(in.media);
    return out;
}

void write_surroundings(const Scene& scene, const std::optional<Color>& sky, Sdl& sdl, TextureWriter& textures, ImageWriter& images, Losses& losses) {
    const Atmosphere& a = scene.atmosphere;
    if (sky) sdl.line("background {", Expression{*sky}, "}");
    else if (!is_black(a.background)) sdl.line("background {", Expression{a.background}, "}");
    losses.add("light of the sky", sky.has_value(), "the same on all surfaces, hidden by nothing");
    losses.add("light of the sky's picture", a.environment_image.has_value(), "a picture that lights nothing");
    if (a.environment_image) write_environment_picture(scene, sdl, images);
    else if (a.sky) write_sky(*a.sky, sdl, textures);
    for (const Fog& fog : a.fogs) write_fog(fog, sdl);
    for (const Rainbow& bow : a.rainbows) write_rainbow(scene, bow, sdl, textures, losses);
    for (const Interior::Medium& medium : a.media) textures.medium(medium);
}

}  // namespace alidade::pov_export

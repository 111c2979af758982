// A seed: one of most things that a scene can hold.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 max_trace_level 5 adc_bailout 1/255 irid_wavelength <0.7, 0.5, 0.4> noise_generator 2 number_of_waves 5 }
#default { finish { ambient 0.1 diffuse 0.6, 0.2 brilliance 2 phong 0.5 phong_size 20 } }
camera { perspective location <1, 2, -5> look_at 0 right 4/3*x angle 50 focal_point 0 aperture 0.2 blur_samples 4 variance 1/128 confidence 0.9 }
light_source { <5, 10, -5> rgb 1 spotlight radius 20 falloff 30 tightness 5 point_at 0 area_light x, y, 3, 3 adaptive 1 jitter circular orient fade_distance 4 fade_power 2 looks_like { sphere { 0, 1 } } }
light_source { y*9 rgb 1 parallel point_at 0 shadowless }
light_group { light_source { 4 rgb 1 } sphere { 0, 1 } global_lights on }
background { rgb <0.1, 0.2, 0.3> }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [0.5 rgb <0, 0, 1>] [1 rgb 0] } scale 2 } pigment { bozo turbulence 0.5 omega 0.4 lambda 3 octaves 4 } rotate 10*x }
fog { fog_type 2 distance 50 rgbft <1, 1, 1, 0.2, 0.1> fog_offset 1 fog_alt 2 turbulence 0.3 }
rainbow { angle 40 width 5 distance 1e4 direction -y color_map { [0 rgbf 1] [1 rgb 1] } }
#declare Wave = function (t) { sin(t) + select(t, 0, 1) }
#declare Wood = texture { pigment { wood color_map { [0 rgb <0.6, 0.3, 0>] [1 rgb 0.2] } warp { repeat x offset y flip z } warp { black_hole 0, 1 strength 2 falloff 2 inverse repeat 3 turbulence 1 } } normal { bumps 0.4 scale 0.1 bump_size 2 accuracy 0.01 } finish { specular 0.4 roughness 0.02 metallic reflection { 0.1, 0.5 fresnel on falloff 2 exponent 0.9 metallic } conserve_energy irid { 0.3 thickness 0.5 turbulence 0.2 } crand 0.1 emission 0.1 } }
#declare Layers = texture { pigment { checker rgb 1, rgb 0 } } texture { pigment { crackle form <1, 1, 0> metric 3 offset 0.2 solid rgbft <1, 0, 0, 0.5, 0.2> } };
union {
    sphere { <0, 1, 0>, 1 texture { Wood } }
    box { -1, 1 texture { Layers } rotate <10, 20, 30> translate -x scale <1, 2, 3> }
    cylinder { 0, y, 0.5 open hollow }
    cone { 0, 1, y, 0.2 }
    torus { 1, 0.25 sturm }
    disc { 0, y, 1, 0.5 }
    plane { y, -1 pigment { hexagon rgb 1, rgb 0.5, rgb 0 } }
    no_shadow double_illuminate
}
difference { sphere { 0, 1 } merge { box { 0, 1 } sphere { x, 0.5 inverse } } clipped_by { plane { y, 0.5 } } bounded_by { clipped_by } cutaway_textures }
intersection { quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 } cubic { <1,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,1,0,0,-1> } quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> } poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> } }
polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }
text { ttf "timrom.ttf" "A" 1, 0.1*x }
mesh { triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z uv_vectors <0, 0>, <1, 0>, <0, 1> texture { Wood } } inside_vector y }
mesh2 { vertex_vectors { 3, 0, x, y } normal_vectors { 1, z } uv_vectors { 1, <0, 0> } texture_list { 2, texture { Wood } texture { pigment { rgb 1 } } } face_indices { 1, <0, 1, 2>, 0, 1, 1 } uv_indices { 1, <0, 0, 0> } }
object { sphere { 0, 1 } matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0> material { texture { pigment { rgbf 1 } } interior { ior 1.5 caustics 0.5 fade_distance 1 fade_power 2 fade_color rgb 1 dispersion 1.1 media { emission 0.2 absorption 0.1 scattering { 1, 0.5 } density { spherical density_map { [0 rgb 0] [1 rgb 1] } } } } interior_texture { Wood } } photons { target reflection on } }
sphere { 0, 1 pigment { average pigment_map { [1 agate agate_turb 0.5] [2 granite] [1 marble turbulence <1, 0, 0.5> triangle_wave] } } normal { slope_map { [0 <0, 1>] [1 <1, 0>] } } }
sphere { 0, 1 pigment { function { x*y + Wave(z) } } }
sphere { 0, 1 texture { mandel 20 exponent 3 interior 1, 2 exterior 3, 4 texture_map { [0 Wood] [1 Layers] } phase 0.2 frequency 2 sine_wave } }
sphere { 0, 1 pigment { julia <0.3, 0.5>, 10 } normal { facets coords 0.5 size 2 } }
sphere { 0, 1 pigment { image_map { png "none.png" map_type 1 interpolate 2 once filter all 0.5 transmit 2, 0.3 gamma srgb } uv_mapping } normal { bump_map { png "none.png" bump_size 2 } } }

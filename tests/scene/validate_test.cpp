// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/scene/sample_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace alidade {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

using test::mesh;
using test::gltf;
Channel& move(Scene& s) { return s.animations[0].channels[0]; }

struct Fault {
    const char* name;
    void (*break_it)(Scene&);
    Severity severity;
    const char* message;   ///< a part of the text of the diagnostic
};

const Fault kFaults[] = {
    // References
    {"RootOutOfRange", [](Scene& s) { s.roots = {NodeId{99}}; }, Severity::error, "the list of roots refers to node 99, but there are only 9"},
    {"ChildOutOfRange", [](Scene& s) { s.nodes[1].children = {NodeId{9}}; }, Severity::error, "sample.gltf:/nodes/1: error: node 1 refers to node 9"},
    {"ClipOutOfRange", [](Scene& s) { s.nodes[1].clips = {NodeId{9}}; }, Severity::error, "node 1 refers to node 9"},
    {"BoundOutOfRange", [](Scene& s) { s.nodes[1].bounds = {NodeId{9}}; }, Severity::error, "node 1 refers to node 9"},
    {"ShapeOutOfRange", [](Scene& s) { s.nodes[1].what = ShapeId{4}; }, Severity::error, "node 1 refers to shape 4, but there are only 4"},
    {"LightOutOfRange", [](Scene& s) { s.nodes[1].what = LightId{1}; }, Severity::error, "node 1 refers to light 1"},
    {"CameraOutOfRange", [](Scene& s) { s.nodes[1].what = CameraId{~0u}; }, Severity::error, "node 1 refers to camera 4294967295"},
    {"MaterialOutOfRange", [](Scene& s) { s.nodes[1].materials[1] = MaterialId{3}; }, Severity::error, "node 1 refers to material 3"},
    {"InsideMaterialOutOfRange", [](Scene& s) { s.nodes[1].inside_material = MaterialId{3}; }, Severity::error, "refers to material 3"},
    {"InteriorOutOfRange", [](Scene& s) { s.nodes[1].interior = InteriorId{1}; }, Severity::error, "node 1 refers to interior 1"},
    {"LightGroupOutOfRange", [](Scene& s) { s.nodes[0].light_group = {LightId{7}}; }, Severity::error, "node 0 \"root\" refers to light 7"},
    {"SkinOutOfRange", [](Scene& s) { s.nodes[1].skin = SkinId{1}; }, Severity::error, "node 1 refers to skin 1"},
    {"OperandOutOfRange", [](Scene& s) { s.signals[2].what = ProductSignal{SignalId{0}, SignalId{7}}; }, Severity::error, "signal 2 refers to signal 7"},
    {"ImageOutOfRange", [](Scene& s) { std::get<ImageSignal>(s.signals[1].what).image = ImageId{2}; }, Severity::error, "signal 1 refers to image 2"},
    {"FunctionOfNothing", [](Scene& s) { s.functions[0].steps.clear(); }, Severity::error, "function 0 has steps that do not fit together"},
    {"FunctionThatLeavesTwoNumbers", [](Scene& s) { s.functions[0].steps.pop_back(); }, Severity::error, "function 0 has steps that do not fit together"},
    {"FunctionThatTakesWhatIsNotThere", [](Scene& s) { s.functions[0].steps.insert(s.functions[0].steps.begin(), {FunctionOp::add}); }, Severity::error, "function 0 has steps that do not fit together"},
    {"FunctionThatCountsBeyondItsEnd", [](Scene& s) { s.functions[0].steps = {{FunctionOp::number}, {FunctionOp::number}, {FunctionOp::sum, 2}, {FunctionOp::number}}; }, Severity::error, "function 0 has steps that do not fit together"},
    {"FunctionWithoutSuchAParameter", [](Scene& s) { s.functions[0].steps[2].a = 3; }, Severity::error, "function 0 refers to parameter 3, but there are only 3"},
    {"FunctionThatCallsItself", [](Scene& s) { s.functions[0].steps[3] = {FunctionOp::call, 0, 3}; }, Severity::error, "function 0 refers to a function before it, 0"},
    {"FunctionThatAsksNoPattern", [](Scene& s) { s.functions[0].steps[3] = {FunctionOp::pattern, 0}; }, Severity::error, "function 0 asks signal 0 for a number, which is no pattern"},
    {"FunctionThatAsksARelief", [](Scene& s) { s.functions[0].steps[3] = {FunctionOp::pigment, 6}; }, Severity::error, "function 0 asks signal 6 for a colour, which is a relief"},
    {"FunctionThatAsksTheSignalThatAsksIt", [](Scene& s) { s.functions[0].steps[3] = {FunctionOp::pattern, 5}; }, Severity::error, "signal 5 reads itself"},
    {"FunctionThatAsksForNoComponent", [](Scene& s) { s.functions[0].steps[3].b = 7; }, Severity::error, "function 0 asks for component 7"},
    {"FunctionOfASplineOfSixComponents", [](Scene& s) { s.functions[0].splines[0].terms = 6; }, Severity::error, "function 0 has a spline of 6 components"},
    {"FunctionOfAnUnsortedSpline", [](Scene& s) { s.functions[0].splines[0].knots.insert(s.functions[0].splines[0].knots.begin(), {1, {}}); }, Severity::error, "function 0 has a spline whose knots are not in order"},
    {"FunctionOutOfRange", [](Scene& s) { std::get<PatternSignal>(s.signals[5].what).function = FunctionId{1}; }, Severity::error, "signal 5 refers to function 1"},
    {"MapEntryOutOfRange", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).map[0].signal = SignalId{8}; }, Severity::error, "refers to signal 8"},
    {"BaseColorOutOfRange", [](Scene& s) { gltf(s).base_color = SignalId{7}; }, Severity::error, "material 0 refers to signal 7"},
    {"OcclusionOutOfRange", [](Scene& s) { gltf(s).occlusion = SignalId{7}; }, Severity::error, "material 0 refers to signal 7"},
    {"ClearcoatOutOfRange", [](Scene& s) { gltf(s).clearcoat_normal = SignalId{7}; }, Severity::error, "material 0 refers to signal 7"},
    {"DensityOutOfRange", [](Scene& s) { s.interiors[0].media[0].density = {SignalId{7}}; }, Severity::error, "interior 0 refers to signal 7"},
    {"AirDensityOutOfRange", [](Scene& s) { s.atmosphere.media[0].density = {SignalId{7}}; }, Severity::error, "the atmosphere refers to signal 7"},
    {"RainbowOutOfRange", [](Scene& s) { s.atmosphere.rainbows.resize(1), s.atmosphere.rainbows[0].colors = SignalId{7}; }, Severity::error, "a rainbow refers to signal 7"},
    {"CameraNormalOutOfRange", [](Scene& s) { s.cameras.resize(1), s.cameras[0].normal = SignalId{9}; }, Severity::error, "refers to signal 9"},
    {"SkyOutOfRange", [](Scene& s) { s.atmosphere.sky->pigments = {SignalId{7}}; }, Severity::error, "the sky refers to signal 7"},
    {"EnvironmentOutOfRange", [](Scene& s) { s.atmosphere.environment_image = ImageId{2}; }, Severity::error, "the environment refers to image 2"},
    {"LooksLikeOutOfRange", [](Scene& s) { s.lights[0].looks_like = NodeId{9}; }, Severity::error, "light 0 refers to node 9"},
    {"ProjectedThroughOutOfRange", [](Scene& s) { s.lights[0].projected_through = NodeId{9}; }, Severity::error, "light 0 refers to node 9"},
    {"JointOutOfRange", [](Scene& s) { s.skins[0].joints = {NodeId{9}}; }, Severity::error, "skin 0 refers to node 9"},
    {"TargetOutOfRange", [](Scene& s) { move(s).target = NodeId{9}; }, Severity::error, "animation 0 refers to node 9"},
    // Graphs
    {"NodeInItself", [](Scene& s) { s.nodes[1].children = {NodeId{1}}; }, Severity::error, "sample.gltf:/nodes/1: error: node 1 is a part of itself"},
    {"CycleThroughAClip", [](Scene& s) { s.nodes[6].clips = {NodeId{3}}; }, Severity::error, "is a part of itself"},
    {"CycleThroughALight", [](Scene& s) { s.nodes[7].children = {NodeId{5}}; }, Severity::error, "is a part of itself"},
    {"CycleOfSignals", [](Scene& s) { s.signals[0].what = ChannelSignal{SignalId{2}, 0}; }, Severity::error, "reads itself"},
    {"FlattenedNode", [](Scene& s) { s.nodes[1].to_parent = Transform::scale({1, 0, 1}); }, Severity::warning, "node 1 has a transform that cannot be inverted: it and all below it are left out"},
    {"FlattenedGroup", [](Scene& s) { s.nodes[0].to_parent = Transform::scale({1, 0, 1}); }, Severity::warning, "node 0 \"root\" has a transform that cannot be inverted"},
    {"NanTransform", [](Scene& s) { s.nodes[1].to_parent.translation.x = kNan; }, Severity::warning, "node 1 has a transform that is not finite"},
    {"MorphWeights", [](Scene& s) { s.nodes[1].morph_weights = {0, 0}; }, Severity::error, "node 1 has 2 morph weights for 1 morph targets"},
    {"MorphWeightsOfASphere", [](Scene& s) { s.nodes[3].morph_weights = {1}; }, Severity::error, "node 3 has 1 morph weights for 0 morph targets"},
    {"JointsWithoutSkin", [](Scene& s) { mesh(s).joint_sets[0].joints[2].y = 1; }, Severity::error, "node 1 has a mesh that names joint 1, but its skin has 1"},
    {"InverseBindCount", [](Scene& s) { s.skins[0].inverse_bind.resize(2); }, Severity::error, "skin 0 has 2 inverse bind matrices for 1 joints"},
    {"InverseBindNan", [](Scene& s) { s.skins[0].inverse_bind[0].linear[1][1] = kNan; }, Severity::error, "inverse bind matrix that is not finite"},
    // Shapes
    {"TriangleOutOfRange", [](Scene& s) { mesh(s).triangles[1].z = 4; }, Severity::error, "sample.gltf:/meshes/0: error: shape 3 \"quad\" has 1 triangles with vertices that do not exist; the first, triangle 1, names vertex 4 of 4"},
    {"NanVertex", [](Scene& s) { mesh(s).positions[3].y = kNanF; }, Severity::warning, "has 1 triangles with a vertex that is not finite: they are left out"},
    {"InfiniteVertex", [](Scene& s) { mesh(s).positions[0].y = std::numeric_limits<float>::infinity(); }, Severity::warning, "has 2 triangles with a vertex"},
    {"NanExactVertex", [](Scene& s) { mesh(s).exact_positions[1].z = kNan; }, Severity::warning, "has 1 triangles with a vertex"},
    {"NanMeshOrigin", [](Scene& s) { mesh(s).origin.x = kNan; }, Severity::warning, "has a number that is not finite: it is left out"},
    {"ExactCount", [](Scene& s) { mesh(s).exact_positions.pop_back(); }, Severity::error, "has 3 exact positions for 4 positions"},
    {"SlotCount", [](Scene& s) { mesh(s).slots.push_back(0); }, Severity::error, "has 3 material slots for 2 triangles"},
    {"FaceCount", [](Scene& s) { mesh(s).faces.pop_back(); }, Severity::error, "has 1 face numbers for 2 triangles"},
    {"CornerCount", [](Scene& s) { mesh(s).normals.corners.pop_back(); }, Severity::error, "has 5 corners with normals for 2 triangles"},
    {"CornerOutOfRange", [](Scene& s) { mesh(s).normals.corners[5] = 1; }, Severity::error, "has a corner that names number 1 of 1 normals"},
    {"CornersWithoutValues", [](Scene& s) { mesh(s).normals.values.clear(); }, Severity::error, "names number 0 of 0 normals"},
    {"UvCount", [](Scene& s) { mesh(s).uvs[0].values.pop_back(); }, Severity::error, "has 3 texture coordinates for 4 positions"},
    {"TangentCount", [](Scene& s) { mesh(s).tangents.values.pop_back(); }, Severity::error, "has 3 tangents for 4 positions"},
    {"ColorCount", [](Scene& s) { mesh(s).colors[0].values.pop_back(); }, Severity::error, "has 3 colors for 4 positions"},
    {"JointCount", [](Scene& s) { mesh(s).joint_sets[0].joints.pop_back(); }, Severity::error, "has 3 joints and 4 weights in set 0 for 4 positions"},
    {"WeightsMissing", [](Scene& s) { mesh(s).joint_sets[0].weights.clear(); }, Severity::error, "has 4 joints and 0 weights in set 0 for 4 positions"},
    {"JointWeightNan", [](Scene& s) { mesh(s).joint_sets[0].weights[1].z = kNanF; }, Severity::error, "has a joint weight that is not finite"},
    {"NodeWeightNan", [](Scene& s) { s.nodes[1].morph_weights = {kNan}; }, Severity::error, "node 1 has a morph weight that is not finite"},
    {"MeshWeightNan", [](Scene& s) { mesh(s).morph_weights = {kNan}; }, Severity::error, "has a morph weight that is not finite"},
    {"NanNormal", [](Scene& s) { mesh(s).normals.values[0].x = kNanF; }, Severity::warning, "has 1 normals that are not finite"},
    {"MorphCount", [](Scene& s) { mesh(s).morphs[0].normals.resize(3); }, Severity::error, "has 3 deltas in morph target 0 for 4 positions"},
    {"MeshMorphWeights", [](Scene& s) { mesh(s).morph_weights = {1, 2}; }, Severity::error, "has 2 morph weights for 1 morph targets"},
    {"SphereNan", [](Scene& s) { std::get<Sphere>(s.shapes[0].geometry).radius = kNan; }, Severity::warning, "shape 0 \"ball\" has a number that is not finite"},
    {"SpherePoint", [](Scene& s) { std::get<Sphere>(s.shapes[0].geometry).radius = 0; }, Severity::warning, "sphere of radius 0"},
    {"PlaneWithoutNormal", [](Scene& s) { std::get<Plane>(s.shapes[1].geometry).normal = Vec3(0); }, Severity::warning, "plane without a normal"},
    {"PlaneNan", [](Scene& s) { std::get<Plane>(s.shapes[1].geometry).distance = kInf; }, Severity::warning, "shape 1 \"floor\" has a number that is not finite"},
    {"BoxNan", [](Scene& s) { std::get<Box>(s.shapes[2].geometry).a.z = kNan; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"BoxLine", [](Scene& s) { std::get<Box>(s.shapes[2].geometry) = {Vec3(0), Vec3(0, 0, 1)}; }, Severity::warning, "box without area"},
    {"DiscNan", [](Scene& s) { s.shapes[2].geometry = Disc{Vec3(0), Vec3(0, 1, 0), kNan, 0}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"DiscWithoutNormal", [](Scene& s) { s.shapes[2].geometry = Disc{Vec3(0), Vec3(0), 1, 0}; }, Severity::warning, "disc without a normal"},
    {"DiscAllHole", [](Scene& s) { s.shapes[2].geometry = Disc{Vec3(0), Vec3(0, 1, 0), 1, -1}; }, Severity::warning, "disc that is all hole"},
    {"CylinderNan", [](Scene& s) { s.shapes[2].geometry = Cylinder{Vec3(0), Vec3(kInf), 1, false}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"CylinderLine", [](Scene& s) { s.shapes[2].geometry = Cylinder{Vec3(0), Vec3(1), 0, false}; }, Severity::warning, "cylinder of radius 0"},
    {"CylinderWithoutLength", [](Scene& s) { s.shapes[2].geometry = Cylinder{Vec3(1), Vec3(1), 1, false}; }, Severity::warning, "cylinder without length"},
    {"ConeNan", [](Scene& s) { s.shapes[2].geometry = Cone{Vec3(0), Vec3(1), 1, kNan, false}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"ConeLine", [](Scene& s) { s.shapes[2].geometry = Cone{Vec3(0), Vec3(1), 0, 0, false}; }, Severity::warning, "cone of radius 0"},
    {"ConeWithoutLength", [](Scene& s) { s.shapes[2].geometry = Cone{Vec3(1), Vec3(1), 1, 0, false}; }, Severity::warning, "cone without length"},
    {"TorusNan", [](Scene& s) { s.shapes[2].geometry = Torus{Vec3(kNan), 1, 1}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"TorusCircle", [](Scene& s) { s.shapes[2].geometry = Torus{Vec3(0), 1, 0}; }, Severity::warning, "torus of minor radius 0"},
    {"QuadricNan", [](Scene& s) { s.shapes[2].geometry = Quadric{Vec3(1), Vec3(0), Vec3(0), kNan}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"QuadricEverywhere", [](Scene& s) { s.shapes[2].geometry = Quadric{Vec3(0), Vec3(0), Vec3(0), 1}; }, Severity::warning, "quadric that is the same everywhere"},
    {"PolynomialTerms", [](Scene& s) { s.shapes[2].geometry = Polynomial{3, {1, 2}}; }, Severity::error, "has 2 coefficients for a polynomial of order 3, which has 20"},
    {"PolynomialOrder", [](Scene& s) { s.shapes[2].geometry = Polynomial{99, {}}; }, Severity::error, "is a polynomial of order 99"},
    {"PolynomialNan", [](Scene& s) { s.shapes[2].geometry = Polynomial{1, {1, kInf, 0, 0}}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"PolygonNan", [](Scene& s) { s.shapes[2].geometry = Polygon{{{Vec3(kNan)}}}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"PolygonLine", [](Scene& s) { s.shapes[2].geometry = Polygon{{{Vec3(0), Vec3(1), Vec3(2)}}}; }, Severity::warning, "polygon without area"},
    {"PolygonBent", [](Scene& s) { s.shapes[2].geometry = Polygon{{{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(0, 1, 0)}}}; }, Severity::warning, "away from its plane"},
    {"ExtrusionNan", [](Scene& s) { s.shapes[2].geometry = Extrusion{{{{Vec2(0), Vec2(kNan)}}}, 0, 1, false}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"ExtrusionDepthNan", [](Scene& s) { s.shapes[2].geometry = Extrusion{{}, 0, kNan, false}; }, Severity::warning, "shape 2 has a number that is not finite"},
    {"ExtrusionOdd", [](Scene& s) { s.shapes[2].geometry = Extrusion{{{{Vec2(0), Vec2(0), Vec2(1)}}}, 0, 1, false}; }, Severity::error, "has an outline of 3 points"},
    // Surfaces
    {"EmptyImage", [](Scene& s) { s.images[0].path.clear(); }, Severity::error, "image 0 \"wood\" has neither a file nor bytes"},
    {"ChannelFour", [](Scene& s) { s.signals[3].what = ChannelSignal{SignalId{0}, 4}; }, Severity::error, "signal 3 reads channel 4"},
    {"ConstantNan", [](Scene& s) { s.signals[0].what = ConstantSignal{Vec4(0, 0, 0, kNan)}; }, Severity::error, "signal 0 has a number that is not finite"},
    {"UvTransformNan", [](Scene& s) { std::get<ImageSignal>(s.signals[1].what).uv_transform[2][0] = kNan; }, Severity::error, "signal 1 has a number"},
    {"MapValueNan", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).map[1].value = kNan; }, Severity::error, "signal 4 has a number"},
    {"WarpNan", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).warps[0].parameters = {kNan}; }, Severity::error, "signal 4 has a number"},
    {"TransmitNan", [](Scene& s) { s.signals[0].what = ConstantSignal{Vec4(0), 0, kNan}; }, Severity::error, "signal 0 has a number that is not finite"},
    {"TurbulenceNan", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).turbulence.lambda = kNan; }, Severity::error, "signal 4 has a number"},
    {"FrequencyInfinite", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).frequency = kInf; }, Severity::error, "signal 4 has a number"},
    {"NoLayers", [](Scene& s) { s.materials[0].layers.clear(); }, Severity::error, "material 0 has no layers"},
    {"GltfNan", [](Scene& s) { gltf(s).ior = kNan; }, Severity::error, "material 0 has a number that is not finite"},
    {"GltfIorBelowOne", [](Scene& s) { gltf(s).ior = 0.5; }, Severity::warning, "material 0 has the refractive index 0.5"},
    {"PovNan", [](Scene& s) { std::get<PovFinish>(s.materials[1].layers[1]).roughness = kNan; }, Severity::error, "material 1 has a number"},
    {"InteriorNan", [](Scene& s) { s.interiors[0].fade_color.y = kNan; }, Severity::error, "interior 0 has a number that is not finite"},
    {"InteriorIor", [](Scene& s) { s.interiors[0].ior = 0; }, Severity::error, "interior 0 has the refractive index 0"},
    {"MediumNan", [](Scene& s) { s.interiors[0].media[0].absorption.x = kNan; }, Severity::error, "interior 0 has a medium with a number"},
    // Lights, cameras, surroundings
    {"IntensityNan", [](Scene& s) { s.lights[0].intensity.x = kNan; }, Severity::error, "light 0 has an intensity that is not finite"},
    {"RangeZero", [](Scene& s) { s.lights[0].range = 0; }, Severity::error, "light 0 has the range 0"},
    {"FadeNan", [](Scene& s) { s.lights[0].fade = LightFade{kNan, 2}; }, Severity::error, "light 0 fades by a number that is not finite"},
    {"SpotTurnedInsideOut", [](Scene& s) { s.lights[0].kind = SpotLight{1, 0.5}; }, Severity::error, "light 0 has a cone from 1 to 0.5 radians"},
    {"SpotNan", [](Scene& s) { s.lights[0].kind = SpotLight{0, kNan}; }, Severity::error, "light 0 has a cone from 0 to nan"},
    {"AreaNegative", [](Scene& s) { AreaLight a; a.width = -1; s.lights[0].kind = a; }, Severity::error, "light 0 has the size -1 by 1"},
    {"AreaRadius", [](Scene& s) { AreaLight a; a.form = AreaLight::Form::disc, a.radius = kInf; s.lights[0].kind = a; }, Severity::error, "light 0 has the radius inf"},
    {"ShadowGrid", [](Scene& s) { s.lights[0].shadow_grid.emplace().size2 = 0; }, Severity::error, "grid of 1 by 0 points"},
    {"ShadowGridAxis", [](Scene& s) { s.lights[0].shadow_grid.emplace().axis1.x = kInf; }, Severity::error, "light 0 has a grid whose axes are not finite"},
    {"CylinderKind", [](Scene& s) { s.cameras[0].cylinder = 5; }, Severity::error, "camera 0 has the cylinder 5"},
    {"ReliefAsSource", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).source = SignalId{6}; }, Severity::error, "signal 4 reads signal 6, which is a relief"},
    {"SourceOutOfRange", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).source = SignalId{99}; }, Severity::error, "refers to signal 99"},
    {"ReliefAsPigment", [](Scene& s) { std::get<PatternSignal>(s.signals[4].what).map[0].signal = SignalId{6}; }, Severity::error, "signal 4 reads signal 6, which is a relief"},
    {"NormalIsNoRelief", [](Scene& s) { std::get<PovFinish>(s.materials[1].layers[0]).normal = SignalId{5}; }, Severity::error, "has signal 5 as its normal, which is no relief"},
    {"TextureMapIsNoPattern", [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).pattern = SignalId{0}; }, Severity::error, "maps textures by signal 0, which is no pattern"},
    {"TextureMapSizes", [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).textures.pop_back(); }, Severity::error, "has 1 textures for 2 entries of a map"},
    {"TextureMapRange", [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).textures[0] = MaterialId{9}; }, Severity::error, "material 2 refers to material 9"},
    {"TextureMapCycle", [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).textures[0] = MaterialId{2}; }, Severity::error, "material 2 is a part of itself"},
    {"CameraNan", [](Scene& s) { s.cameras[0].up.x = kNan; }, Severity::error, "camera 0 has a number that is not finite"},
    {"CameraFlat", [](Scene& s) { s.cameras[0].up = s.cameras[0].right; }, Severity::warning, "camera 0 has its right, up and direction in one plane"},
    {"ApertureNegative", [](Scene& s) { s.cameras[0].aperture = -1; }, Severity::error, "camera 0 has the aperture -1"},
    {"BlurSamplesNegative", [](Scene& s) { s.cameras[0].blur_samples = -1; }, Severity::error, "camera 0 has -1 blur samples"},
    {"BackgroundNan", [](Scene& s) { s.atmosphere.background.x = kNan; }, Severity::error, "the background has a number"},
    {"EnvironmentNan", [](Scene& s) { s.atmosphere.environment = Color(kNan); }, Severity::error, "the environment has a number"},
    {"FogNan", [](Scene& s) { s.atmosphere.fogs[0].distance = kNan; }, Severity::error, "a fog has a number"},
    {"RainbowNan", [](Scene& s) { s.atmosphere.rainbows.resize(1), s.atmosphere.rainbows[0].arc_angle = kNan; }, Severity::error, "a rainbow has a number"},
    {"SkyNan", [](Scene& s) { s.atmosphere.sky->transform.translation.x = kNan; }, Severity::error, "the sky has a number that is not finite"},
    {"AirNan", [](Scene& s) { s.atmosphere.media[0].extinction = kNan; }, Severity::error, "the atmosphere has a medium with a number"},
    {"ShadowClearanceBelowZero", [](Scene& s) { s.settings.shadow_clearance = -1; }, Severity::error, "the clearance of shadows is negative"},
    {"SettingsNan", [](Scene& s) { s.settings.assumed_gamma = kNan; }, Severity::error, "the render settings have a number"},
    // Animation
    {"NoKeys", [](Scene& s) { move(s).times.clear(); }, Severity::error, "sample.gltf:/nodes/1: error: animation 0, channel 0, has no keys"},
    {"KeysGoBack", [](Scene& s) { move(s).times = {1, 0}; }, Severity::error, "has times that do not increase"},
    {"KeyNan", [](Scene& s) { move(s).times[1] = kNanF; }, Severity::error, "channel 0, has a number that is not finite"},
    {"ValueCount", [](Scene& s) { move(s).values.pop_back(); }, Severity::error, "has 5 numbers for 2 keys: they should be 6"},
    {"RotationWidth", [](Scene& s) { move(s).path = ChannelPath::rotation; }, Severity::error, "has 3 numbers a value where its target takes 4"},
    {"WeightsWidth", [](Scene& s) { s.animations[0].channels[1].width = 2; }, Severity::error, "channel 1, has 2 numbers a value where its target takes 1"},
    {"AnimatedMatrix", [](Scene& s) { s.nodes[1].trs.reset(); }, Severity::error, "moves a node whose place is given by a matrix"},
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class EveryFault : public testing::TestWithParam<Fault> {};

/// One thing is broken: one message, with its severity and its place.
TEST_P(EveryFault, IsReportedOnce) {
    Scene scene = test::sample_scene();
    GetParam().break_it(scene);
    const Diagnostics said = validate(scene);
    ASSERT_EQ(said.list().size(), 1u) << said.text();
    EXPECT_EQ(said.list()[0].severity, GetParam().severity);
    EXPECT_THAT(said.text(), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(Validate, EveryFault, testing::ValuesIn(kFaults), [](const auto& info) { return std::string(info.param.name); });

TEST(Validate, TheSampleSceneIsValid) { EXPECT_EQ(validate(test::sample_scene()).text(), ""); }

TEST(Validate, AnEmptySceneIsValid) { EXPECT_EQ(validate(Scene()).text(), ""); }

TEST(Validate, WhatPovRayDrawsIsNoFault) {
    Scene s = test::sample_scene();
    std::get<Sphere>(s.shapes[0].geometry).radius = -2;
    std::get<Box>(s.shapes[2].geometry) = {Vec3(1, 2, 3), Vec3(-1, 2, -3)};   // corners in any order, and flat
    s.cameras[0].direction *= 1e-3;
    EXPECT_EQ(validate(s).text(), "");
}

TEST(Validate, ATransformThatDrawsNothingMayBeSingular) {
    Scene s = test::sample_scene();
    s.nodes[2].to_parent = Transform::scale(Vec3(0));   // a joint
    s.nodes[5].to_parent = Transform::scale(Vec3(0));   // a light: but it looks like a box
    EXPECT_EQ(validate(s).warnings(), 1u);
    s.lights[0].looks_like.reset();
    EXPECT_EQ(validate(s).warnings(), 0u);
}

/// The cycle is found wherever it is: here in a part that no root reaches, far behind its entry.
TEST(Validate, NamesANodeOfTheCycle) {
    std::vector<Node> nodes(1000);
    for (uint32_t i = 1; i + 1 < 1000; ++i) nodes[i].children = {NodeId{i + 1}};
    nodes[999].children = {NodeId{990}};
    const Diagnostics said = validate(test::scene_of(nodes));
    ASSERT_EQ(said.errors(), 1u);
    EXPECT_THAT(said.text(), testing::ContainsRegex("error: node 99[0-9] is a part of itself"));
}

TEST(Validate, TwoFilesOfOneNameKeepTheirPlaces) {
    Scene s = test::sample_scene();
    s.files = {{"a.inc"}, {"a.inc"}, {"b.inc"}};
    s.nodes[1].from = {2, 5, 1, ""};
    s.nodes[1].to_parent = Transform::scale(Vec3(0));
    EXPECT_THAT(validate(s).text(), HasSubstr("b.inc:5:1: warning"));
}

/// Linear time, no recursion: a chain and a fan of 300,000 nodes, and a diamond stair with 2^300000 paths.
TEST(Validate, BigGraphs) {
    constexpr uint32_t kCount = 300000;
    const std::function<void(std::vector<Node>&, uint32_t)> links[] = {
        [](auto& nodes, uint32_t i) { nodes[i].children = {NodeId{i + 1}}; },
        [](auto& nodes, uint32_t i) { nodes[0].children.push_back(NodeId{i + 1}); },
        [](auto& nodes, uint32_t i) { nodes[i].children = {NodeId{i + 1}, NodeId{i + 1}}; },
    };
    for (const auto& link : links) {
        std::vector<Node> nodes(kCount);
        for (uint32_t i = 0; i + 1 < kCount; ++i) link(nodes, i);
        nodes.back().what = ShapeId{0};
        EXPECT_EQ(validate(test::scene_of(std::move(nodes))).text(), "");
    }
}

}  // namespace
}  // namespace alidade

// SPDX-License-Identifier: Apache-2.0
// Edges of all slopes, thin bars and a floor of tiles: what antialiasing is for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -7> look_at <0, 0.9, 0> angle 45 }
light_source { <-6, 9, -8>, rgb 1 }
background { rgb <0.35, 0.5, 0.7> }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.15 scale 0.5 } finish { ambient 0.1 diffuse 0.8 } }
#for (I, 0, 11)
  cylinder { <-2.2, 0, 0.5>, <-2.2 + 2.6 * cos(radians(8 * I)), 3 * sin(radians(8 * I)), 0.5>, 0.012
    pigment { rgb <0.9, 0.2, 0.1> } finish { ambient 0.2 diffuse 0.7 } }
#end
sphere { <1.4, 0.9, 0>, 0.9 pigment { rgb <0.9, 0.85, 0.6> } finish { ambient 0.1 diffuse 0.6 specular 0.5 roughness 0.01 reflection 0.2 } }

// SPDX-License-Identifier: Apache-2.0
// One surface of the sixth degree, (x^2 + y^2 + 9/4 z^2 - 1)^3 = (x^2 + 9/80 z^2) y^3 (Taubin, 1993), as a polynomial or, for a program that has those, as an isosurface.
#version 3.7;
#ifndef (Polynomial) #declare Polynomial = 1; #end
#ifndef (Sturm) #declare Sturm = 0; #end
#ifndef (Accuracy) #declare Accuracy = 1e-10; #end
#ifndef (Gradient) #declare Gradient = 1000; #end
global_settings { assumed_gamma 1 }
camera { location <1.1, 0.9, -4> look_at <0, 0.08, 0> angle 42 }
light_source { <-5, 7, -8>, rgb 1 }
background { rgb <0.5, 0.6, 0.75> }
plane { y, -1.25 pigment { checker rgb 0.85, rgb 0.3 scale 0.5 } finish { ambient 0.1 diffuse 0.8 } }
#if (Polynomial)
  poly { 6, <
    1, 0, 0, 0, 3, 0, 0, 6.75, 0, -3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3,
    0, -1, 13.5, 0, -6, 0, 0, 0, 0, 15.1875, 0, -13.5, 0, 3, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 6.75, 0, -3, 0,
    -0.1125, 0, 0, 15.1875, 0, -13.5, 0, 3, 0, 0, 0, 0, 0, 0, 11.390625, 0, -15.1875, 0, 6.75, 0, -1>
    #if (Sturm) sturm #end
#else
  #declare S = function(x, y, z) { x*x + y*y + 2.25*z*z - 1 }
  isosurface {
    function { S(x, y, z)*S(x, y, z)*S(x, y, z) - (x*x + 0.1125*z*z)*y*y*y }
    contained_by { sphere { 0, 1.5 } }
    accuracy Accuracy max_gradient Gradient
#end
    pigment { rgb <0.85, 0.1, 0.15> } finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 }
  }

// SPDX-License-Identifier: Apache-2.0
// Two bubbles of glass within each other, before a mirror: light that is bent and turned back many times.
#version 3.7;
#ifndef (Level) #declare Level = 16; #end
#ifndef (Bailout) #declare Bailout = 1/255; #end
global_settings { assumed_gamma 1 max_trace_level Level adc_bailout Bailout }
camera { location <0, 1.6, -6> look_at <0, 1, 0> angle 40 }
light_source { <-5, 8, -6>, rgb 1 }
background { rgb <0.4, 0.55, 0.8> }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.3, 0.1, 0.1> } finish { ambient 0.1 diffuse 0.7 } }
plane { z, 4 pigment { rgb 0.1 } finish { ambient 0 diffuse 0.1 reflection 0.7 } }
#declare Glass = texture { pigment { rgbf <0.97, 0.99, 0.97, 0.95> } finish { ambient 0 diffuse 0 specular 0.6 roughness 0.005 reflection { 0.05, 1 fresnel on } conserve_energy } }
#for (I, 0, 1)
  difference {
    sphere { <0, 1.1, 0>, 1.1 - 0.3 * I }
    sphere { <0, 1.1, 0>, 1.0 - 0.3 * I }
    texture { Glass } interior { ior 1.5 }
  }
#end
sphere { <-1.8, 0.5, -0.6>, 0.5 texture { Glass } interior { ior 1.5 } }

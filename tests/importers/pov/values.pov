//---- promotion of floats and short vectors
#debug concat(vstr(3, <1,2,3>*2, ",", 0, 1), "\n")          // expect 2.0,4.0,6.0
#debug concat(vstr(3, <1,2,3>*<4,5>, ",", 0, 1), "\n")      // expect 4.0,10.0,0.0
#debug concat(vstr(5, <1,2,3,4,5>+1, ",", 0, 0), "\n")      // expect 2,3,4,5,6
#debug concat(vstr(4, t*2, ",", 0, 1), "\n")                // expect 0.0,0.0,0.0,2.0
#debug concat(vstr(2, u+v, ",", 0, 1), "\n")                // expect 1.0,1.0
#debug concat(str((<1,2,3>*2).z - <4,5>.v, 0, 1), "\n")     // expect 1.0
//---- literal vectors, which are lexed as one, and those that are not
#debug concat(vstr(3, < -1 , +.5, 2.5e1>, ",", 0, 2), " ", vstr(2, -<1,-2>, ",", 0, 0), "\n")   // expect -1.00,0.50,25.00 -1,2
#debug concat(vstr(3, <1 -2, 3, /* no */ 4>, ",", 0, 0), " ", vstr(3, <1 2 3>, ",", 0, 0), " ", str((<1,2>.y>=2), 0, 0), "\n")   // expect -1,3,4 1,2,3 1
#declare Chosen = function(x) { select(x <1, 2, 3> 2, 4) };
#debug concat(str(Chosen(0), 0, 0), str(Chosen(2), 0, 0), "\n")   // expect 41
#debug concat(str(123456789012345678, 0, 0), " ", str(0.1234567890123456789, 0, 17), " ", str(1.5e-3, 0, 4), "\n")   // expect 123456789012345680 0.12345678901234568 0.0015
#debug concat(str(-1.5, -8, 2), "|", str(1.5, 8, 2), "|", str(2.5, 0, 0), str(3.5, 0, 0), "|", str(1, 0, -1), "\n")   // expect -0001.50|    1.50|24|1.000000
//---- operators: unary before product before sum; comparisons in brackets alone
#debug concat(str(2--3, 0, 0), str(!0+1, 0, 0), str(-!0, 0, 0), str(2+3*4, 0, 0), "\n")   // expect 52-114
#debug concat(str((1|0&0), 0, 0), str((1 < 2 & 3 > 2), 0, 0), str((1 < 1+1e-11), 0, 0), str((1 = 1+1e-11), 0, 0), "\n")   // expect 0111
#debug concat(str((0 ? 2 : 1 ? 5 : 6), 0, 0), str((1 ? <1,2,3> : 2).y, 0, 0), "\n")       // expect 52
#debug concat(str(("a" < "b"), 0, 0), str(("a" = "b"), 0, 0), str(("b" != "a"), 0, 0), "\n")   // expect 101
//---- colours are kept in single precision
#declare C = rgb .1;
#debug concat(str(C.red, 0, 17), "\n")                      // expect 0.10000000149011612
#declare C = rgb <.1,.2,.3> filter .4;
#declare D = color C transmit .5;
#debug concat(vstr(5, D, ",", 0, 9), "\n")                  // expect 0.100000001,0.200000003,0.300000012,0.400000006,0.500000000
#declare E = color red .5 green .25;
#debug concat(vstr(5, E, ",", 0, 2), "\n")                  // expect 0.50,0.25,0.00,0.00,0.00
#declare F = rgbt .5;
#debug concat(vstr(5, F, ",", 0, 1), "\n")                  // expect 0.5,0.5,0.5,0.0,0.5
#declare G = rgbf .5;
#debug concat(vstr(5, G, ",", 0, 1), " ", str(G.gray, 0, 3), "\n")   // expect 0.5,0.5,0.5,0.5,0.0 0.500
//---- a component where a vector is read: the others of its vector stand behind it. POV-Ray prints the same
#declare V = <2, 3, 5>; #declare U = <2, 7>;
#debug concat(vstr(3, vrotate(V.y, 0), ",", 0, 0), " ", vstr(3, vrotate(V.y*2, 0), ",", 0, 0), " ", vstr(3, vrotate(-V.y, 0), ",", 0, 0), " ", vstr(3, vrotate(U.y, 0), ",", 0, 0), "\n")   // expect 3,3,5 6,3,5 -3,3,5 7,7,0
#declare A = box { 0, 1 scale V.y } #declare B = box { 0, V.x } #declare C = box { 0, 1 translate V.y*2 }
#debug concat(vstr(3, max_extent(A), ",", 0, 0), " ", vstr(3, max_extent(B), ",", 0, 0), " ", vstr(3, max_extent(C), ",", 0, 0), "\n")   // expect 3,3,5 2,3,5 7,4,6
#debug concat(vstr(3, V.y, ",", 0, 0), " ", vstr(3, vrotate(x.x, 0), ",", 0, 0), " ", vstr(3, vrotate((V).y, 0), ",", 0, 0), " ", str(vlength(V.x), 0, 4), "\n")   // expect 3,3,5 1,0,0 3,3,5 6.1644
#debug concat(vstr(3, vrotate((V.y), 0), ",", 0, 0), " ", vstr(3, vrotate(2*V.y, 0), ",", 0, 0), " ", vstr(3, vrotate(V.y*x, 0), ",", 0, 0), " ", vstr(3, vrotate(sqrt(V.y*3), 0), ",", 0, 0), "\n")   // expect 3,3,3 6,6,6 3,0,0 3,3,3
#declare K = V.y; #macro Turned(What) vrotate(What, 0) #end #debug concat(vstr(3, vrotate(K, 0), ",", 0, 0), " ", vstr(3, Turned(V.y), ",", 0, 0), "\n")   // expect 3,3,3 3,3,3
//---- with charset utf8, strings are counted by characters
global_settings { charset utf8 }
#debug concat(str(strlen("a\u00e9b"), 0, 0), str(asc("\u00e9"), 0, 0), substr("a\u00e9b", 3, 1), str(strlen(chr(233)), 0, 0), str(strlen("éa"), 0, 0), str(strcmp("é", "z"), 0, 0), "\n")   // expect 3233b12111
//---- without it the bytes of a literal above 127 are blanks; escapes and chr() are characters
#declare Before = "aéb"; #declare S = "a\u00e9éb";
#debug concat(str(strlen(Before), 0, 0), " ", str(asc(substr(Before, 2, 1)), 0, 0), " ", str(strlen(S), 0, 0), " ", str(asc(substr(S, 2, 1)), 0, 0), " ", str(asc(substr(S, 3, 1)), 0, 0), "\n")   // expect 4 32 5 233 32
#debug concat(str(asc(chr(1046)), 0, 0), " ", str(strlen(chr(1046)), 0, 0), " ", str(strcmp(Before, concat("a", chr(233), "b")), 0, 0), "\n")   // expect 1046 1 -201
global_settings { charset utf8 }
#debug concat(str(strlen(Before), 0, 0), " ", str(strlen("aéb"), 0, 0), "\n")   // expect 4 3
//---- a second semicolon, which a macro brings
#macro Three() 3; #end #declare A = Three(); #declare B = <1, 2>;; #debug concat(str(A, 0, 0), str(B.y, 0, 0), "\n")   // expect 32
//---- strings
#debug concat(substr("hello", 2, 3), strupr("aBc"), strlwr("aBc"), chr(65), str(asc("A"), 0, 0), "\n")   // expect ellABCabcA65
#debug concat(str(strlen("abc"), 0, 0), str(strcmp("a", "b"), 0, 0), str(strcmp("abc", "a"), 0, 0), "\n")  // expect 3-198
#debug concat(str(val("12abc"), 0, 3), str(val("x"), 0, 0), str(val(" -3.5e2"), 0, 0), "\n")   // expect 12.0000-350
#debug concat("a\u0041\\ \"x\"\n")                          // expect aA\ "x"
#debug concat(str(strlen(chr(233)), 0, 0), str(strcmp(chr(233), chr(122)), 0, 0), str(asc(chr(233)), 0, 0), "\n")   // expect 1111233
#debug concat(datetime(0.5), datetime(7500.25, "%Y"), "\n")   // expect 2000-01-01 12:00:00Z2020
//---- str: width, zeros, precision
#debug concat(str(1, 10, 3), str(-1, -10, 3), str(2.5, 0, 0), str(1/3, 0, -4), str(1/3, 8, -1), "\n")   // expect      1.000-00001.00020.3333330.333333
#debug concat(str(-1e-9, 0, 3), "\n")                       // expect -0.000
//---- rand: POV-Ray's own numbers, a stream for each seed
#declare R = seed(123);
#declare S = seed(1);
#debug concat(str(rand(R), 0, 15), " ", str(rand(R), 0, 15), "\n")   // expect 0.904772982211963 0.995137868913621
#debug concat(str(rand(S), 0, 17), "\n")                    // expect 0.42199287526821549
//---- arrays: copied when assigned, elements by reference to macros, subscripts truncate
#declare A = array[2][2] {{1, 2}, {3, 4}}
#declare B = A;
#declare B[0][1] = 7;
#debug concat(str(A[0][1], 0, 0), str(B[0][1], 0, 0), str(A[1.9][0], 0, 0), str(dimensions(A), 0, 0), str(dimension_size(A, 2), 0, 0), "\n")   // expect 27322
#declare N = array[3];
#debug concat(str(defined(N[0]), 0, 0), "\n")               // expect 0
#declare N[0] = "x";
#debug concat(str(defined(N[0]), 0, 0), N[0], "\n")         // expect 1x
#declare Outer = array[2] {A, A}
#declare Outer[0][1][1] = 9;
#debug concat(str(A[1][1], 0, 0), str(Outer[0][1][1], 0, 0), str(Outer[1][1][1], 0, 0), "\n")   // expect 494
//---- an array grows no loop through itself
#declare A = array[2] {1, 2}
#declare B = array[2] {A, A}
#declare B[0] = B;
#declare B[0][0] = B;
#debug concat(str(B[1][1], 0, 0), str(B[0][1][1], 0, 0), "\n")   // expect 22
//---- splines
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,3> }
#debug concat(vstr(3, S(0.5), ",", 0, 2), str(S(7).z, 0, 1), "\n")   // expect 0.50,1.00,1.503.0
#declare T = spline { cubic_spline 0,1 1,2 2,5 3,1 }
#debug concat(vstr(3, T(1.5), ",", 0, 5), "\n")             // expect 3.81250,3.81250,0.00000
//---- functions of floats
#declare F = function(a, b) { a*2 + b }
#declare K = 3;
#declare G = function { x + y*K - F(z, 1) }
#declare K = 100;
#debug concat(str(F(1, 2), 0, 1), " ", str(G(1, 2, 3), 0, 1), "\n")   // expect 4.0 0.0
#declare H = function(x) { select(mod(x, 2), 1, 0, 1) }
#debug concat(str(H(3), 0, 0), str(H(4), 0, 0), "\n")       // expect 10
//---- some directives are obeyed without their #
declare A = 7;
default { finish { ambient 1 } }
#debug concat(str(A, 0, 0), "\n")                           // expect 7
//---- alpha is an old name of filter
#declare C = color red 1 alpha .25;
#debug concat(vstr(5, C, ",", 0, 2), "\n")                 // expect 1.00,0.00,0.00,0.25,0.00
#declare D = alpha .5;
#debug concat(vstr(5, D, ",", 0, 2), "\n")                 // expect 0.00,0.00,0.00,0.50,0.00
//---- before version 1.5 operators stand in brackets alone
#version 1.49
#declare V = <1 -1 3>
#debug concat(vstr(3, V, ",", 0, 0), "\n")                 // expect 1,-1,3
#declare S = (2+3)
#debug concat(str(S, 0, 0), "\n")                          // expect 5
#version 1.5
#debug concat(vstr(3, <1 -1 3>, ",", 0, 0), "\n")          // expect 0,3,0
//---- srgb is brought to the scene's assumed_gamma, the first that is given
#version 3.7;
global_settings { assumed_gamma 2.2 }
global_settings { assumed_gamma 1 }
#declare C = srgb <.5,.7,.02>;
#debug concat(vstr(3, C, ",", 0, 5), "\n")                  // expect 0.49623,0.69420,0.05280
#declare D = srgbft <-.5,.03,.2,.3,.4>;
#debug concat(vstr(5, D, ",", 0, 5), "\n")                  // expect 0.00000,0.06348,0.21243,0.30000,0.40000
//---- sRGB in a scene of sRGB
global_settings { assumed_gamma srgb }
#declare C = srgb <.5,.7,.02>;
#debug concat(vstr(3, C, ",", 0, 5), "\n")                  // expect 0.50000,0.70000,0.02000
//---- components of floats
#declare K = 3;
#declare L = K.x;
#macro At(F) concat(str(F.u, 0, 0), str(F.red*2 + F.x, 0, 0)) #end
#debug concat(str(L, 0, 0), At(K), At(4), "\n")             // expect 339412
//---- #undef of an element
#declare A = array[2] {1, 2}
#undef A[1]
#ifdef (A[1]) #debug "still there\n" #end
#declare A[1] = 5;
#debug concat(str(A[0], 0, 0), str(A[1], 0, 0), "\n")       // expect 15
#undef A #ifdef (A) #debug "still there\n" #end
//---- #local and the elements of arrays: one that has a value keeps it, unless the array was declared in the same macro or file, or is its parameter
#declare A = array[2] {1, 2}
#declare B = array[1]
#macro Outer() #local A[0] = 7; #local B[0] = 8; #local B[0] = 9; #end
#macro Parameter(C) #local C[1] = 6; #end
#macro Own() #local D = array[1] {1} #local D[0] = 3; #debug str(D[0], 0, 0) #end
Outer()
Parameter(A)
Own()
#local B[0] = B[0] + 1;
#debug concat(str(A[0], 0, 0), str(A[1], 0, 0), str(B[0], 0, 0), "\n")   // expect 3169
//---- no colour is black
#declare C = color;
#declare P = pigment { color }
#debug concat(vstr(5, C, ",", 0, 0), "\n")                  // expect 0,0,0,0,0

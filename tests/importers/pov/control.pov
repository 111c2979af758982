//---- loops
#for (i, 1, 3) #debug concat(str(i, 0, 0), "\n") #end       // expect 1
#debug concat(str(i, 0, 0), "\n")                           // expect 2
#declare I = 0;                                             // expect 3
#while (I < 2) #declare I = I + 1; #debug "w\n" #end        // expect 4
#for (k, 0, 0.3, 0.1) #debug concat(str(k, 0, 1), "\n") #if (k > 0.15) #break #end #end   // expect w
// expect w
// expect 0.0
// expect 0.1
// expect 0.2
//---- switch falls through until break
#declare A = 5;
#switch (A) #case (5) #debug "5\n" #case (6) #debug "6\n" #range (0, 1) #debug "r\n" #break #else #debug "else\n" #end   // expect 5
#switch (A) #case (1) #debug "1\n" #else #debug "other\n" #end   // expect 6
// expect r
// expect other
#switch (2) #range (3, 1) #debug "in\n" #break #range (1 5) #debug "within\n" #break #end   // expect within
#switch (1) #range (2, 3) #debug "r\n" #break #case (0) #debug "0\n" #break #else #debug "below\n" #end   // expect below
//---- the values of #switch and #case may be conditions, and what stands before the first clause is obeyed
#declare Q = 1;
#switch (Q = 1 | Q = 2) #debug "before\n" #case (0) #debug "0\n" #break #case (1) #debug "1\n" #break #end   // expect before
#switch (Q) #case (Q > 1) #debug "no\n" #break #case (Q > 0 & !0) #debug "yes\n" #break #end   // expect 1
#switch (Q ? 3 : 4) #declare Before = 7; #range ((Q <= 0), 2) #debug "no\n" #break #case (3) #debug "3\n" #break #end   // expect yes
#debug concat(str(Before, 0, 0), "\n")                      // expect 3
#switch (2) #debug "outer\n" #switch (2) #case (2) #debug "inner\n" #break #case (1) #debug "no\n" #end #case (1) #debug "no\n" #case (2) #debug "behind\n" #end   // expect 7
// expect outer
// expect inner
// expect behind
//---- a # before a word that is no directive means nothing
#declare V = #color rgb #<1, 2, 3>; #debug #concat(str(V.y, 0, 0), "\n")   // expect 2
#global_settings { #assumed_gamma 1 } #sphere { 0, 1 #translate y }
#declare Ball = sphere { 0, 1 } #macro Said(What) #debug concat(#What, "\n") #end union { object { #Ball } object { #Ball } } #Ball
#Said("m")                                                  // expect m
//---- what is not taken is not read
#if (0) #include "nowhere.inc" #declare = ; #elseif (1) #debug "second\n" #else #debug "third\n" #end   // expect second
#ifdef (Nothing) #debug "defined\n" #else #debug "not\n" #end   // expect not
#ifndef (Nothing) #debug "not\n" #end                       // expect not
#ifdef (clock) #debug "defined\n" #else #debug "a word\n" #end   // expect a word
//---- read: behind a last comma a loop makes one more turn with what it had, as POV-Ray's; names beyond the end keep their values
#fopen F "numbers.txt" write
#write (F, "1, 2, // two\n 3,\n")
#fclose F
#fopen F "numbers.txt" read
#while (defined(F)) #read (F, N) #debug concat(str(N, 0, 0), "\n") #end   // expect 1
// expect 2
// expect 3
// expect 3
#fopen F "numbers.txt" write
#write (F, "1, <2, 3>, /* 7, */ 4\n")
#fclose F
#fopen F "numbers.txt" read
#declare D = 9;
#read (F, A, B, C, D)
#debug concat(str(A, 0, 0), str(B.y, 0, 0), str(C, 0, 0), str(D, 0, 0), str(defined(F), 0, 0), "\n")   // expect 13490
#debug concat(str(file_exists("numbers.txt"), 0, 0), "\n")   // expect 1
//---- break leaves a macro
#macro Q() #debug "q\n" #if (1) #break #end #debug "r\n" #end
Q()                                                         // expect q
#debug "s\n"                                                // expect s
//---- macros: by reference, by value, as expressions, recursive
#macro Set(a) #local a = 7; #end
#declare B = array[2] {1, 2}
#declare C = 1;
#declare D = 1;
Set(C) Set(B[0]) Set((D)) Set(+D)
#debug concat(str(C, 0, 0), str(B[0], 0, 0), str(D, 0, 0), "\n")   // expect 771
#macro Twice(x1) x1*2 #end
#debug concat(str(Twice(3) + Twice(Twice(1)), 0, 0), "\n")  // expect 10
#macro Fib(n) #if (n < 2) #local r = n; #else #local r = Fib(n-1) + Fib(n-2); #end r #end
#debug concat(str(Fib(12), 0, 0), "\n")                     // expect 144
//---- scopes: local hides, declare assigns the newest, unknown ones become global
#declare A = 1;
#macro Inner() #declare A = A + 10; #declare Fresh = 5; #end
#macro Outer() #local A = 2; Inner() #debug concat(str(A, 0, 0), "\n") #end
Outer()                                                     // expect 12
#debug concat(str(A, 0, 0), str(Fresh, 0, 0), "\n")         // expect 15
#undef Fresh
#debug concat(str(defined(Fresh), 0, 0), "\n")              // expect 0
//---- comments nest, blanks stand behind #
/* a /* b */ #debug "no\n" */
#  declare A = 4; // #debug "no\n"
#debug concat(str(A, 0, 0), "\n")                           // expect 4
//---- a declaration behind a texture is not part of it
#declare T = texture { pigment { rgb 1 } }
#declare U = texture { T } texture { pigment { rgbt 1 } }
#debug "both\n"                                             // expect both
//---- blocks that nobody knows are read to their end
sphere { 0, 1 pigment { bozo turbulence .5 color_map { [0 rgb 1] [.5, .7 color red 1 color blue 1] } scale <1,2,3> } matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0> }
mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,2> } }
global_settings { assumed_gamma srgb radiosity { count 10 } }
isosurface { function { x*x + y - 1 } contained_by { box { -1, 1 } } }
#debug "end\n"                                              // expect end
//---- a local holds what a macro returns, though the macro has locals of that name
#macro Turned(a) #local T = a; transform { rotate T } #end
#macro User() #local T = Turned(3); #local S = transform { T } #debug "kept\n" #end
User()                                                      // expect kept
#declare T = 1;
#declare T = Turned(4);
#declare O = sphere { 0, 1 transform { T } }
#debug "global\n"                                           // expect global
//---- a # without a word is nothing
sphere { 0, 1 # }
#debug "end\n"                                              // expect end
//---- the commas of #for may be left out
#for (I 1 3) #debug str(I, 0, 0) #end #debug "\n"           // expect 123
#for (I 4 0 -2) #debug str(I, 0, 0) #end #debug "w\n"       // expect w
//---- a macro may use what was declared before it, though no ; stands between them
#macro Print(Tex) #debug "used\n" #end
#declare T = texture { pigment { rgb 1 } }
Print(T)                                                    // expect used
//---- the commas between arguments may be left out
#macro Sum(a, b) #debug concat(str(a.y + b, 0, 0), "\n") #end
Sum(<1,2,3> 4)                                              // expect 6
//---- what is declared anew in front of its arguments is still what it was there
#declare Fn = function(x) { x*2 };
#declare Q = Fn #for (Fn, 1, 1) (4); #end
#debug concat(str(Q, 0, 0), "\n")                           // expect 8
//---- an array is declared before the next directive looks at it
#macro Changed(P) #local Q = array[2] { 7, 8 } #declare P = Q #end
#declare A = array[3] { 1, 2, 3 } Changed(A)
#debug concat(str(dimension_size(A, 1), 0, 0), str(A[0], 0, 0), "\n")   // expect 27
#declare B = array[3] { 1, 2, 3 } #declare B = A #if (dimension_size(B, 1) = 2) #debug "now\n" #end   // expect now
//---- before version 3.5 declarations need no semicolons: each is finished before the next directive looks at it
#version 3.1
#declare A = 2
#declare B = A*2
#declare C = -B
#if (C < 0) #debug concat(str(C, 0, 0), "\n") #end         // expect -4
#declare D = color red A green B
#declare E = D*2
#debug concat(str(E.green, 0, 0), "\n")                    // expect 8
#declare V = <1,2,A>
#declare F = V.z + #if (A = 2) 3 #else 4 #end
#debug concat(str(F, 0, 0), "\n")                          // expect 5
#declare L = array[2]
#declare L[0] = F
#declare L[1] = L[0]
#debug concat(str(L[1], 0, 0), "\n")                       // expect 5
//---- in brackets directives may stand between the parts of a value
#declare A = (1 #if (1) + 3 #end);
#debug concat(str(A, 0, 0), "\n")                          // expect 4
//---- a directive behind a declared texture finds it declared
#declare T = texture { pigment { rgb x } }
#ifdef (T) #debug "yes\n" #end                             // expect yes
#default { texture { T } }
//---- the version holds for the directive behind it
#version 3.1
#declare A = 2
#debug concat(str(A, 0, 0), "\n")                          // expect 2
//---- the version of a patched POV-Ray
#version unofficial 3.5;
#debug concat(str(version, 0, 1), "\n")                    // expect 3.5
//---- read: the first name for which a value was looked for in vain is defined, if it has none (probed)
#fopen F "numbers.txt" write
#write (F, "1,2,")
#fclose F
#fopen F "numbers.txt" read
#read (F, A, B, C, D)
#debug concat(str(defined(C), 0, 0), str(defined(D), 0, 0), "\n")   // expect 10
#debug str(C, 0, 0)     // expect error 7:12 C is not declared
//---- versions before the first are known, as in POV-Ray
#version .5;
#debug str(version, 0, 1)   // expect 0.5
//---- what the frame gives has names that a scene may declare anew
#debug concat(str(frame_number, 0, 0), " ", str((image_width > 0), 0, 0), " ", str(defined(clock_delta), 0, 0), "\n")   // expect 0 1 1
#declare image_width = 7; #declare final_clock = "late";
#debug concat(str(image_width * 2, 0, 0), " ", final_clock, "\n")   // expect 14 late
#macro Shown(frame_number) #debug concat(str(frame_number, 0, 0), "\n") #end Shown(44)   // expect 44
#local clock_delta = 3; #undef clock_delta
#debug concat(str(defined(clock_delta), 0, 0), "\n")   // expect 0

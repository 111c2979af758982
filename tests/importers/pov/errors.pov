//---- a name that is not declared, with the nearest one
#declare Radius = 2;
sphere { 0, Radios }    // expect error 2:13 Radios is not declared
//---- an error in a loop is said once
#for (I, 1, 5)
    sphere { I, Foo }   // expect error 2:17 Foo is not declared
#end
//---- a missing semicolon
#declare A = 3 B        // expect error 1:16 ; is expected behind the value of A
//---- a condition that is a vector
#if (<1,2> = <1,2>) #end   // expect error 1:5 a condition is a float, not a vector of 2
//---- a comparison of different things
#if (1 = "a") #end         // expect error 1:8 two numbers or two strings can be compared
//---- subscripts
#declare A = array[3] {1, 2, 3}
#debug str(A[3], 0, 0)  // expect error 2:14 the subscript 3 is out of range
//---- subscripts below zero, by more than is forgiven
#declare A = array[3] {1, 2, 3}
#debug str(A[-2e-10], 0, 0)  // expect error 2:14 the subscript -2e-10 is negative
//---- a subscript behind what is no array
#declare A = 3;
#declare B = A[1];      // expect error 2:15 A is no array but a float
#declare V = <1, 2>;
#declare V[0] = 1;      // expect error 4:11 V is no array but a vector of 2
sphere { V[1], 1 }      // expect error 5:11 V is no array but a vector of 2
//---- keywords that go on behind what is written come first
light { 0, 1 }          // expect error 1:1 light is not declared
//---- a comma before all values
sphere { , 1 }          // expect error 1:10 a value is expected before the ,
//---- an element without a value
#declare A = array[3];
#debug str(A[1], 0, 0)  // expect error 2:12 this array element has no value yet
//---- too few arguments
#macro P(a, b) #end
P(1)                    // expect error 2:1 P takes 2 arguments, and 1 are given
//---- a word of the language cannot be declared
#declare sphere = 3;    // expect error 1:10 sphere is a word of the language
//---- no #end
#if (1)                 // expect error 1:1 #if has no #end
//---- an #end too many
#end                    // expect error 1:1 #end stands without
//---- an open comment
 /* never closed        // expect error 1:2 the comment is not closed
//---- an open string
#debug "abc             // expect error 1:8 the string is not closed
//---- an open block
sphere { 0, 1           // expect error 1:1 sphere is not closed
//---- arithmetic with a string
#declare A = 1 + "x";   // expect error 1:16 a string is no number
//---- the scene's own error
#error "stop"           // expect error 1:1 the scene says: stop
//---- reading goes on behind an error
#declare A = ;          // expect error 1:14 a number, a vector or another value is expected
#declare B = foo;       // expect error 2:14 foo is not declared
sphere { 0, B2 }        // expect error 3:13 B2 is not declared
//---- roots and logarithms
#debug str(sqrt(-1), 0, 3)   // expect error 1:12 the square root of -1 is not real
//---- files outside of the scene's folder
#include "/etc/hostname"   // expect error 1:1 the file /etc/hostname is not found
//---- an endless macro
#macro M() M() #end
M()                     // expect error 1:12 macros call one another
//---- a step of 0
#for (i, 0, 1, 0) #end  // expect error 1:16 the step of a #for must not be 0
//---- a #switch needs a value to match
#switch (1) #end                 // expect error 1:13 #case or #range is expected in #switch before #end
#switch (1) #else #debug "no\n" #end   // expect error 2:13 #case or #range is expected in #switch before #else
#switch (1)
#debug "no\n"
#end                    // expect error 5:1 #case or #range is expected in #switch before #end
//---- a # before a name that is none
#delcare A = 3          // expect error 1:1 there is no directive #delcare
//---- a vector that is not closed
#declare V = <1, 2, 3;  // expect error 1:22 > is expected behind the components of a vector, not ;
//---- the name of a file without quotes
#include colors.inc     // expect error 1:10 the name of a file stands in quotes
//---- the end behind a directive
sphere { 0, 1 }
#declare                // expect error 3:1 a name is expected behind #declare, not the end of the text
//---- what follows from an error is not said
#declare A = <1, 2;     // expect error 1:19 > is expected behind the components of a vector, not ;
#declare B = A*2;
sphere { 0, B }
sphere { 0, Radios }    // expect error 4:13 Radios is not declared
//---- strings in the character set of the system, which POV-Ray refuses, whatever is in them
global_settings { charset sys }
#declare A = chr(65);
#declare B = "abc";   // expect error 3:14 POV-Ray 3.7 refuses strings behind charset sys

# A folder of the tree is a static library, alidade_<folder>, with the warnings, sanitizers and include path that all of them share.

add_library(alidade_flags INTERFACE)
target_compile_options(alidade_flags INTERFACE -Wall -Wextra -Wpedantic $<$<BOOL:${ALIDADE_WERROR}>:-Werror>)
# g++ 12 warns falsely about moved and joined std::strings (GCC bugs 105651, 105329).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(alidade_flags INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# Every geometric result is a contract, bit for bit: no fused multiply-add that the source does not spell.
target_compile_options(alidade_flags INTERFACE -ffp-contract=off)
# Nobody asks for errno after a square root, and nobody replaces one of our functions while the program is loaded: so g++ inlines them, as clang does.
target_compile_options(alidade_flags INTERFACE -fno-math-errno -fno-semantic-interposition)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
  # In bits. On processors of Intel's a single vector of 512 slows down all that comes near it. The corners of a triangle were copied in one, and rays were a tenth slower (bench/results/accel_peers.md).
  target_compile_options(alidade_flags INTERFACE -mprefer-vector-width=256)
endif()
if(ALIDADE_SANITIZE)
  target_compile_options(alidade_flags INTERFACE -fsanitize=${ALIDADE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(alidade_flags INTERFACE -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/not_sanitized.txt)
  endif()
  target_link_options(alidade_flags INTERFACE -fsanitize=${ALIDADE_SANITIZE})
  target_sources(alidade_flags INTERFACE $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/cmake/sanitizer_options.cpp>)
endif()

# Eight files of a folder are compiled as one: what they instantiate is most of the work, and is done once. So the names that are a file's own differ from its
# neighbours', and from those outside of the anonymous namespace, which they would hide. Not so in preset `debug`, and where rays and
# colours are computed. GCC takes the anonymous namespaces of the outer file alone for a file's own.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(alidade_flags INTERFACE $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-subobject-linkage>)
endif()

# What most files include is read once: cmake/precompiled.h, compiled with the first folder, and again for the tests with GoogleTest. It must mean
# the same in every file, so fmt's own definitions come from here. A file still includes what it uses: preset `debug` builds without.
target_compile_definitions(alidade_flags INTERFACE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
target_compile_options(alidade_flags INTERFACE "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")

# alidade_folder(<folder> [COLD] SOURCES ... [PUBLIC libs...] [PRIVATE libs...]): alidade::<folder>, here and where it is installed. COLD: it asks other
# folders for the work, so a compiler's full effort, a third of its time, or half of it under sanitizers, would buy nothing.
function(alidade_folder folder)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(alidade_${folder} STATIC ${ARG_SOURCES})
  target_include_directories(alidade_${folder} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/alidade>)
  target_link_libraries(alidade_${folder} PUBLIC ${ARG_PUBLIC} PRIVATE $<BUILD_INTERFACE:alidade_flags> ${ARG_PRIVATE})
  set_target_properties(alidade_${folder} PROPERTIES EXPORT_NAME ${folder})
  if(ARG_COLD AND ALIDADE_SANITIZE)
    target_compile_options(alidade_${folder} PRIVATE -O0)
  elseif(ARG_COLD)
    target_compile_options(alidade_${folder} PRIVATE $<$<CONFIG:Release>:-O2>)
  endif()
  # The fuzzer sees its way by the readers' branches alone, and code that it watches takes no headers from code that it does not.
  if(ALIDADE_FUZZ AND folder STREQUAL importers)
    set(watched ON)
    target_compile_options(alidade_importers PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(watched OR folder STREQUAL core OR (ARG_COLD AND ALIDADE_SANITIZE))   # a header that is compiled at another level is refused
    target_precompile_headers(alidade_${folder} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  else()
    target_precompile_headers(alidade_${folder} REUSE_FROM alidade_core)
  endif()
  add_library(alidade::${folder} ALIAS alidade_${folder})
endfunction()

# A test's own code is compiled for the compiler's speed, not for its own: its folders keep their options.
add_library(alidade_test_flags INTERFACE)
if(ALIDADE_SANITIZE)
  target_compile_options(alidade_test_flags INTERFACE -O0)
else()
  # g++ knows less of what is initialised at -O1, and says so of OpenMesh.
  target_compile_options(alidade_test_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# alidade_test(<name> SOURCES ... LIBS ...): a GoogleTest program, one ctest entry for each of its tests.
function(alidade_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBS" ${ARGN})
  if(ALIDADE_FULL)
    set(ARG_TIMEOUT 36000)
  elseif(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE alidade_flags alidade_test_flags ${ARG_LIBS} GTest::gtest_main GTest::gmock)
  target_precompile_headers(${name} REUSE_FROM alidade_tests_precompiled)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()

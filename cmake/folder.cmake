# A folder of the tree is a static library, alidade_<folder>, with the warnings, sanitizers and include path that all of them share.

add_library(alidade_flags INTERFACE)
target_compile_options(alidade_flags INTERFACE -Wall -Wextra -Wpedantic $<$<BOOL:${ALIDADE_WERROR}>:-Werror>)
# g++ 12 warns falsely about "text" + std::string (GCC bug 105651).
target_compile_options(alidade_flags INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# Every geometric result is a contract, bit for bit: no fused multiply-add that the source does not spell.
target_compile_options(alidade_flags INTERFACE -ffp-contract=off)
if(ALIDADE_SANITIZE)
  target_compile_options(alidade_flags INTERFACE -fsanitize=${ALIDADE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(alidade_flags INTERFACE -fsanitize=${ALIDADE_SANITIZE})
endif()

# alidade_folder(<folder> SOURCES ... [PUBLIC libs...] [PRIVATE libs...]): alidade::<folder>, here and where it is installed.
function(alidade_folder folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(alidade_${folder} STATIC ${ARG_SOURCES})
  target_include_directories(alidade_${folder} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/alidade>)
  target_link_libraries(alidade_${folder} PUBLIC ${ARG_PUBLIC} PRIVATE $<BUILD_INTERFACE:alidade_flags> ${ARG_PRIVATE})
  set_target_properties(alidade_${folder} PROPERTIES EXPORT_NAME ${folder})
  add_library(alidade::${folder} ALIAS alidade_${folder})
endfunction()

# alidade_test(<name> SOURCES ... LIBS ...): a GoogleTest program, one ctest entry for each of its tests.
function(alidade_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBS" ${ARGN})
  if(ALIDADE_FULL)
    set(ARG_TIMEOUT 36000)
  elseif(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE alidade_flags ${ARG_LIBS} GTest::gtest_main GTest::gmock)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()

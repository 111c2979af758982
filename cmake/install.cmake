# What `cmake --install` leaves: bin/alidade, include/alidade/<folder>/..., one static library a folder, and a CMake package:
#   find_package(alidade)                    target_link_libraries(x alidade::alidade)     everything
#   find_package(alidade COMPONENTS accel)   target_link_libraries(x alidade::accel)       the accelerators over plain triangles, and core
#   find_package(alidade COMPONENTS stress)  target_link_libraries(x alidade::stress)      the same, and what measures them beside others
include(CMakePackageConfigHelpers)

add_library(alidade_all INTERFACE)
set_target_properties(alidade_all PROPERTIES EXPORT_NAME alidade)
add_library(alidade::alidade ALIAS alidade_all)

set(installed_folders ${ALIDADE_FOLDERS})
list(REMOVE_ITEM installed_folders numerics tools)
foreach(folder ${installed_folders})
  if(TARGET alidade_${folder})
    install(TARGETS alidade_${folder} EXPORT alidadeTargets)
    target_link_libraries(alidade_all INTERFACE alidade_${folder})
  endif()
endforeach()
# What others may include: the types, the tables and the three functions; not how importers and integrators do their work.
file(GLOB public_headers RELATIVE ${PROJECT_SOURCE_DIR} core/*.h scene/*.h accel/*.h)
list(REMOVE_ITEM public_headers core/deep_png.h)
# stress/builder.h and what stands behind run.h stay inside.
list(APPEND public_headers eval/shapes/shape_ops.h topology/decimate.h topology/normals.h topology/report.h topology/reshape.h topology/subdivide.h importers/importer.h exporters/exporter.h exporters/losses.h
     exporters/output_files.h tracer/film.h tracer/options.h tracer/render.h
     stress/growth.h stress/hardware.h stress/measure.h stress/peer.h stress/ray_file.h stress/rays.h stress/run.h stress/scene.h stress/table.h stress/tree_file.h)
foreach(header ${public_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/alidade/${folder})
endforeach()

install(TARGETS alidade_all EXPORT alidadeTargets)
if(TARGET alidade)
  install(TARGETS alidade)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/alidade)
install(EXPORT alidadeTargets NAMESPACE alidade:: DESTINATION ${package_dir})
configure_package_config_file(cmake/alidadeConfig.cmake.in alidadeConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(alidadeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/alidadeConfig.cmake ${PROJECT_BINARY_DIR}/alidadeConfigVersion.cmake DESTINATION ${package_dir})

# SPDX-License-Identifier: MIT
# Files that other projects link to. A shared libnicol has the components `runtime` (the library) and `development` (headers, CMake
# package, pkg-config); the static one has `static`, all in one, which is installed on request beside the shared one.
include(CMakePackageConfigHelpers)

# Before 1.0 the interface may change between minor versions.
write_basic_package_version_file(nicolConfigVersion.cmake COMPATIBILITY SameMinorVersion)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/nicol)
set(documents ${PROJECT_SOURCE_DIR}/LICENSE ${CMAKE_CURRENT_LIST_DIR}/third_party.txt)
# From the folders of nicol.pc and nicolConfig.cmake, so that the prefix can be moved.
file(RELATIVE_PATH NICOL_PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH NICOL_PREFIX_FROM_PACKAGE ${CMAKE_INSTALL_FULL_LIBDIR}/cmake/nicol ${CMAKE_INSTALL_PREFIX})
cmake_path(SET NICOL_PREFIX_FROM_PC NORMALIZE "${NICOL_PREFIX_FROM_PC}")

# nicol_install_development(COMPONENT pkg_config_file [EXCLUDE_FROM_ALL]): headers, nicol.pc and the package's version.
function(nicol_install_development component pkg_config)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${component} ${ARGN})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/nicolConfigVersion.cmake DESTINATION ${package} COMPONENT ${component} ${ARGN})
  install(FILES ${pkg_config} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component} ${ARGN})
endfunction()

set(on_request "")
if(BUILD_SHARED_LIBS)
  set(on_request EXCLUDE_FROM_ALL)
  install(TARGETS nicol EXPORT nicol
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
  install(FILES ${documents} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
  # The library depends on nothing that its users have to find, so its targets are the whole package.
  install(EXPORT nicol FILE nicolConfig.cmake NAMESPACE nicol:: DESTINATION ${package} COMPONENT development)
  set(NICOL_NEEDS "")
  set(NICOL_LINKS "")
  configure_file(nicol.pc.in nicol.pc @ONLY)
  nicol_install_development(development ${CMAKE_CURRENT_BINARY_DIR}/nicol.pc)
endif()

install(FILES ${NICOL_ARCHIVE} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT static ${on_request})
install(FILES ${documents} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT static ${on_request})
get_property(NICOL_NEEDS_LIBRARIES GLOBAL PROPERTY NICOL_NEEDS_LIBRARIES)
get_property(packages GLOBAL PROPERTY NICOL_NEEDS_PACKAGES)
list(TRANSFORM packages REPLACE "(.+)" "find_dependency(\\1)")
list(JOIN packages "\n" NICOL_FINDS_PACKAGES)
configure_file(nicolConfig.cmake.in static/nicolConfig.cmake @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/static/nicolConfig.cmake DESTINATION ${package} COMPONENT static ${on_request})
get_property(names GLOBAL PROPERTY NICOL_NEEDS_PKG_CONFIG)
list(JOIN names " " NICOL_NEEDS)
set(NICOL_LINKS " -lstdc++ -lm -ldl -pthread")
if(NICOL_MESH_FILES)
  string(PREPEND NICOL_LINKS " -lOpenMeshCore")
endif()
configure_file(nicol.pc.in static/nicol.pc @ONLY)
nicol_install_development(static ${CMAKE_CURRENT_BINARY_DIR}/static/nicol.pc ${on_request})

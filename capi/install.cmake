# SPDX-License-Identifier: MIT
# What others link to: components `runtime` (the library) and `development` (headers, CMake package, pkg-config).
include(CMakePackageConfigHelpers)

install(TARGETS nicol EXPORT nicol
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${CMAKE_CURRENT_LIST_DIR}/third_party.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

# The library depends on nothing that its users have to find, so its targets are the whole package.
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/nicol)
install(EXPORT nicol FILE nicolConfig.cmake NAMESPACE nicol:: DESTINATION ${package} COMPONENT development)
# Before 1.0 the interface may change between minor versions.
write_basic_package_version_file(nicolConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/nicolConfigVersion.cmake DESTINATION ${package} COMPONENT development)

# From the folder of nicol.pc, so that the prefix can be moved.
file(RELATIVE_PATH NICOL_PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
cmake_path(SET NICOL_PREFIX_FROM_PC NORMALIZE "${NICOL_PREFIX_FROM_PC}")
configure_file(nicol.pc.in nicol.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/nicol.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

# SPDX-License-Identifier: MIT
# libnicol.so: the C interface, and nothing else of ours visible.
add_library(nicol SHARED)
target_include_directories(nicol PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(nicol PRIVATE nicol_capi)
target_link_options(nicol PRIVATE
  -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/nicol.map -Wl,--exclude-libs,ALL
  # Context threads and Mesa's exit handlers must not outlive the code they run.
  -Wl,-z,nodelete)
if(NOT (NICOL_SANITIZE AND CMAKE_CXX_COMPILER_ID MATCHES "Clang"))
  # Clang links the sanitizers' run time to programs alone.
  target_link_options(nicol PRIVATE -Wl,--no-undefined)
endif()
set_target_properties(nicol PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "" LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/nicol.map)

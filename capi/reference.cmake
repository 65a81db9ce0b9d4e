# SPDX-License-Identifier: MIT
# `cmake --build build --target reference`: the C headers as pages to read, in build/capi/reference/html.
find_package(Doxygen QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  return()
endif()

configure_file(reference/Doxyfile.in reference/Doxyfile @ONLY)
# The filter's failure would not be Doxygen's, so it runs before.
set(mark ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/reference/mark_comments.py)
add_custom_target(reference
  COMMAND ${mark} ${PROJECT_SOURCE_DIR}/include/nicol.h > reference/nicol.h
  COMMAND ${mark} ${PROJECT_SOURCE_DIR}/include/nicol_psh.h > reference/nicol_psh.h
  COMMAND ${mark} ${PROJECT_SOURCE_DIR}/include/nicol_files.h > reference/nicol_files.h
  COMMAND ${DOXYGEN_EXECUTABLE} ${CMAKE_CURRENT_BINARY_DIR}/reference/Doxyfile
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${CMAKE_CURRENT_SOURCE_DIR}/reference/drawings reference/html/drawings
  COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/samples/gallery/conventions.png reference/html/drawings
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
  COMMENT "Writing ${CMAKE_CURRENT_BINARY_DIR}/reference/html")

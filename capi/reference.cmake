# SPDX-License-Identifier: MIT
# `cmake --build build --target reference`: nicol.h as pages to read, in build/capi/reference/html.
find_package(Doxygen QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  return()
endif()

configure_file(reference/Doxyfile.in reference/Doxyfile @ONLY)
# The filter's failure would not be Doxygen's, so it runs before.
set(marked ${CMAKE_CURRENT_BINARY_DIR}/reference/nicol.h)
add_custom_target(reference
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/reference/mark_comments.py
          ${PROJECT_SOURCE_DIR}/include/nicol.h > ${marked}
  COMMAND ${DOXYGEN_EXECUTABLE} ${CMAKE_CURRENT_BINARY_DIR}/reference/Doxyfile
  COMMENT "Writing ${CMAKE_CURRENT_BINARY_DIR}/reference/html")

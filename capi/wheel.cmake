# SPDX-License-Identifier: MIT
# The wheel for Python carries Embree beside libnicol, because Embree is opened at run time, so that no tool finds it, and
# the licences of its libraries. OpenGL's libraries are the system's.
set_target_properties(nicol PROPERTIES INSTALL_RPATH "$ORIGIN")
find_library(NICOL_EMBREE NAMES libembree4.so.4 libembree3.so.3 REQUIRED)
file(REAL_PATH ${NICOL_EMBREE} embree)
cmake_path(GET NICOL_EMBREE FILENAME soname)
install(FILES ${embree} DESTINATION ${CMAKE_INSTALL_LIBDIR} RENAME ${soname} COMPONENT runtime)

foreach(package libembree3-3 libembree4-4 libtbb12 libopenexr-3-1-30 libimath-3-1-29 libopenmesh1 libpng16-16
                libturbojpeg0 zlib1g)
  install(FILES /usr/share/doc/${package}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME ${package}.txt
          COMPONENT runtime OPTIONAL)
endforeach()

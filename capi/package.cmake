# SPDX-License-Identifier: MIT
# `cpack` in the build folder makes libnicol0.1, libnicol-dev, nicol-tools, nicol-serve and python3-nicol for Debian.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Nicol authors <maintainers@nicol.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Each package is a group: a component that `cmake --install` knows as well, and one of what only Debian has.
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

# Debian's policy asks for a copyright and a changelog in each package.
set(debian ${CMAKE_CURRENT_LIST_DIR}/debian)
set(made ${CMAKE_CURRENT_BINARY_DIR}/debian)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
file(READ ${CMAKE_CURRENT_LIST_DIR}/third_party.txt third_party)
file(WRITE ${made}/copyright "${license}\n${third_party}")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${made}/changelog "nicol (${PROJECT_VERSION}) unstable; urgency=medium

  * See the project's CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
execute_process(COMMAND gzip -9nf ${made}/changelog)

set(same "libnicol0.1 (= ${PROJECT_VERSION})")

# nicol_debian_package(COMPONENT NAME SECTION SUMMARY DEPENDS)
macro(nicol_debian_package component name section summary depends)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "Nicol renders scenes as images of Stokes vectors. This package:
${summary}.")
  set(CPACK_COMPONENT_${upper}_GROUP ${component})
  set(CPACK_COMPONENT_DEBIAN_${upper}_GROUP ${component})
  list(APPEND CPACK_COMPONENTS_ALL ${component} debian_${component})
  install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
    COMPONENT debian_${component} EXCLUDE_FROM_ALL)
endmacro()

# Embree is opened at run time, so no linker names it. Shadows and the reference method need it.
nicol_debian_package(runtime libnicol0.1 libs "library" "libembree4-4 | libembree3-3")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libegl1 | libosmesa6")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${debian}/triggers)
nicol_debian_package(development libnicol-dev libdevel "headers, CMake package, pkg-config file, documents, examples" ${same})
nicol_debian_package(tools nicol-tools graphics "nicol-render and nicol-convert" ${same})
nicol_debian_package(serve nicol-serve httpd "images over HTTP, with a unit for systemd" ${same})
nicol_debian_package(python python3-nicol python "Python" "python3, ${same}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-numpy)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)

# The headers name documents by their paths in the repository.
set(documents ${CMAKE_INSTALL_DATADIR}/doc/libnicol-dev)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${documents} COMPONENT debian_development EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples DESTINATION ${documents} COMPONENT debian_development EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN *.md)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/capi/reference DESTINATION ${documents}/capi COMPONENT debian_development
  EXCLUDE_FROM_ALL FILES_MATCHING PATTERN *.md PATTERN *.svg)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/embed_c ${PROJECT_SOURCE_DIR}/samples/embed_cmake
  DESTINATION ${documents}/examples COMPONENT debian_development EXCLUDE_FROM_ALL)
# bash and zsh find the completion of a program by the name of a file.
function(nicol_completion component program)
  install(FILES ${debian}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME ${program} COMPONENT debian_${component} EXCLUDE_FROM_ALL)
  configure_file(${debian}/completion.zsh ${made}/_${program} @ONLY)
  install(FILES ${made}/_${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
    COMPONENT debian_${component} EXCLUDE_FROM_ALL)
endfunction()
nicol_completion(tools nicol-render)
nicol_completion(tools nicol-convert)
nicol_completion(serve nicol-serve)
nicol_completion(python nicol-dataset)
install(FILES ${debian}/nicol-serve.default DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/nicol-serve
  COMPONENT debian_serve EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/python/nicol DESTINATION lib/python3/dist-packages
  COMPONENT debian_python EXCLUDE_FROM_ALL PATTERN __pycache__ EXCLUDE)
install(PROGRAMS ${debian}/nicol-dataset TYPE BIN COMPONENT debian_python EXCLUDE_FROM_ALL)

# Manual pages say what --help says.
find_program(NICOL_HELP2MAN help2man)
if(NICOL_HELP2MAN)
  foreach(program nicol-render nicol-convert nicol-serve)
    set(page ${made}/${program}.1)
    set(about_nicol-render "render Stokes images of scenes")
    set(about_nicol-convert "convert images of polarized light")
    set(about_nicol-serve "render scenes over HTTP")
    if(TARGET ${program})
      add_custom_command(OUTPUT ${page}.gz
        COMMAND ${NICOL_HELP2MAN} -N -n ${about_${program}} -o ${page} $<TARGET_FILE:${program}>
        COMMAND gzip -9nf ${page}
        DEPENDS ${program} VERBATIM)
      list(APPEND pages ${page}.gz)
      set(component tools)
      if(program STREQUAL nicol-serve)
        set(component serve)
      endif()
      install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT debian_${component} OPTIONAL EXCLUDE_FROM_ALL)
    endif()
  endforeach()
  # Its --help needs numpy.
  execute_process(COMMAND /usr/bin/python3 -c "import numpy" RESULT_VARIABLE absent OUTPUT_QUIET ERROR_QUIET)
  if(NOT absent)
    set(page ${made}/nicol-dataset.1)
    add_custom_command(OUTPUT ${page}.gz
      COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 NICOL_LIBRARY=$<TARGET_FILE:nicol>
              PYTHONPATH=${PROJECT_SOURCE_DIR}/samples/python
              ${NICOL_HELP2MAN} -N --version-string=${PROJECT_VERSION} -n "render data sets of polarized light" -o ${page}
              ${debian}/nicol-dataset
      COMMAND gzip -9nf ${page}
      DEPENDS nicol ${debian}/nicol-dataset ${PROJECT_SOURCE_DIR}/samples/python/nicol/dataset/program.py VERBATIM)
    list(APPEND pages ${page}.gz)
    install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT debian_python OPTIONAL EXCLUDE_FROM_ALL)
  endif()
  add_custom_target(nicol_manual ALL DEPENDS ${pages})
endif()
include(CPack)

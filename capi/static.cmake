# SPDX-License-Identifier: MIT
# libnicol.a: everything of ours in one object whose only global symbols are those of the C interface, so that no name
# clashes with a program's. The target nicol_archive makes it; the component `static` is what others link to.
find_program(NICOL_OBJCOPY NAMES ${CMAKE_OBJCOPY} objcopy REQUIRED)
get_property(folders GLOBAL PROPERTY NICOL_FOLDERS)
if(NICOL_SCENE_FILES)
  list(APPEND folders pugixml::static)
endif()
list(TRANSFORM folders REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE archives)
set(static ${CMAKE_CURRENT_BINARY_DIR}/static)
file(MAKE_DIRECTORY ${static})
set(NICOL_ARCHIVE ${static}/libnicol.a)
add_custom_command(OUTPUT ${NICOL_ARCHIVE}
  COMMAND ${CMAKE_COMMAND} -E rm -f nicol.o libnicol.a
  COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o nicol.o $<TARGET_OBJECTS:nicol_capi>
          --start-group ${archives} --end-group
  # Symbols of GCC's binding "unique" become local only after they have become weak.
  COMMAND sh -c "${CMAKE_NM} -gP --defined-only nicol.o | sed -n 's/ u .*//p' > unique"
  COMMAND ${NICOL_OBJCOPY} --weaken-symbols=unique nicol.o
  COMMAND ${NICOL_OBJCOPY} --wildcard --keep-global-symbol=nicol_* nicol.o
  COMMAND ${CMAKE_AR} qcs libnicol.a nicol.o
  COMMAND ${CMAKE_COMMAND} -E rm nicol.o unique
  DEPENDS nicol_capi $<TARGET_OBJECTS:nicol_capi> ${folders}
  WORKING_DIRECTORY ${static} COMMENT "Linking libnicol.a" COMMAND_EXPAND_LISTS VERBATIM)
add_custom_target(nicol_archive DEPENDS ${NICOL_ARCHIVE})

if(NOT BUILD_SHARED_LIBS)
  set_target_properties(nicol_archive PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_library(nicol STATIC IMPORTED GLOBAL)
  add_dependencies(nicol nicol_archive)
  set_target_properties(nicol PROPERTIES IMPORTED_LOCATION ${NICOL_ARCHIVE}
    INTERFACE_INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}/include)
  get_property(needs GLOBAL PROPERTY NICOL_NEEDS_LIBRARIES)
  target_link_libraries(nicol INTERFACE ${needs} ${CMAKE_DL_LIBS} stdc++ m)
endif()

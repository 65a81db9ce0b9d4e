# SPDX-License-Identifier: MIT
# Finds a Python (NICOL_PYTHON) that has the glad generator, and makes the OpenGL 4.5 core loader with it.
if(NOT NICOL_PYTHON)
  find_program(NICOL_PATH_PYTHON python3)
  foreach(candidate IN ITEMS /usr/bin/python3 ${NICOL_PATH_PYTHON})
    execute_process(COMMAND ${candidate} -c "import glad, glad.__main__"
      RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
    if(NOT missing)
      set(NICOL_PYTHON ${candidate} CACHE FILEPATH "Python that has the glad 2 generator")
      break()
    endif()
  endforeach()
  if(NOT NICOL_PYTHON)
    message(FATAL_ERROR "No Python with the glad 2 generator: install python3-glad or set NICOL_PYTHON")
  endif()
endif()

set(NICOL_GLAD_DIR ${CMAKE_CURRENT_BINARY_DIR}/glad)
add_custom_command(OUTPUT ${NICOL_GLAD_DIR}/src/gl.c ${NICOL_GLAD_DIR}/include/glad/gl.h
  COMMAND ${NICOL_PYTHON} -m glad --quiet --reproducible --api gl:core=4.5 --extensions GL_KHR_debug,GL_EXT_memory_object
    --out-path ${NICOL_GLAD_DIR} c --mx
  COMMENT "Generating the OpenGL loader" VERBATIM)
# Generated code is compiled without our warnings, and as system headers.
add_library(nicol_glad STATIC ${NICOL_GLAD_DIR}/src/gl.c ${NICOL_GLAD_DIR}/include/glad/gl.h)
target_include_directories(nicol_glad SYSTEM PUBLIC ${NICOL_GLAD_DIR}/include)
set_property(GLOBAL APPEND PROPERTY NICOL_FOLDERS nicol_glad)

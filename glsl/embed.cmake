# SPDX-License-Identifier: MIT
# nicol_embed_shaders(TARGET FUNCTION FILES file... [SHARED file...]): compiles the stages among the files into
# TARGET, which then defines nicol::gl::FUNCTION(). Shared files can be included too. A change of any rebuilds.
set(NICOL_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed.py)

function(nicol_embed_shaders target function)
  cmake_parse_arguments(ARG "" "" "FILES;SHARED" ${ARGN})
  set(files)
  foreach(file IN LISTS ARG_FILES ARG_SHARED)
    cmake_path(ABSOLUTE_PATH file)
    list(APPEND files ${file})
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${NICOL_PYTHON} ${NICOL_EMBED_SCRIPT} ${output} ${function} ${files}
    DEPENDS ${NICOL_EMBED_SCRIPT} ${files}
    COMMENT "Embedding shaders: ${function}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

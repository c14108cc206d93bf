# Generated code compiles without warnings under a second compiler too.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
file(GLOB rules "${CMAKE_CURRENT_LIST_DIR}/rules/*.jrule" "${JRULE_SOURCE_DIR}/examples/cmake-consumer/*.jrule")
foreach(file IN LISTS rules)
  get_filename_component(name "${file}" NAME_WLE)
  run(ignored STATUS 0 COMMAND "${JRULE}" emit cpp "${file}" -o "${WORK_DIR}")
  run(output STATUS 0 COMMAND "${COMPILER}" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
      -Werror -I "${JRULE_SOURCE_DIR}/runtime/include" -I "${CMAKE_CURRENT_LIST_DIR}/rules" "${WORK_DIR}/${name}.cpp")
  if(NOT output STREQUAL "")
    message(FATAL_ERROR "${name}.cpp:\n${output}")
  endif()
endforeach()

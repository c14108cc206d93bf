# What the script tests share. Given: JRULE, JRULE_SOURCE_DIR, WORK_DIR, GENERATOR, CXX, LAUNCHER.

# run(<variable> STATUS <regex> COMMAND ...): runs it and keeps what it prints; fails unless its exit status matches.
function(run variable)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STATUS" "COMMAND")
  execute_process(COMMAND ${ARG_COMMAND} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status MATCHES "^(${ARG_STATUS})$")
    message(FATAL_ERROR "exit status ${status}, not ${ARG_STATUS}: ${ARG_COMMAND}\n${output}")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

function(expect text regex)
  if(NOT text MATCHES "${regex}")
    message(FATAL_ERROR "this does not match `${regex}`:\n${text}")
  endif()
endfunction()

function(expect_not text regex)
  if(text MATCHES "${regex}")
    message(FATAL_ERROR "this matches `${regex}`:\n${text}")
  endif()
endfunction()

# A fresh copy of project/ with these rules, configured.
function(prepare)
  file(REMOVE_RECURSE "${WORK_DIR}")
  file(COPY "${CMAKE_CURRENT_LIST_DIR}/project/" DESTINATION "${WORK_DIR}/source")
  file(COPY ${ARGN} DESTINATION "${WORK_DIR}/source")
  run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
      "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DJRULE_EXECUTABLE=${JRULE}"
      "-DJRULE_SOURCE_DIR=${JRULE_SOURCE_DIR}")
endfunction()

# build(<variable> STATUS <regex>)
function(build variable)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STATUS" "")
  run(output STATUS "${ARG_STATUS}" COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

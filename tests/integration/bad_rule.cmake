# A rule that is refused stops the build with a line that editors find, leaves nothing behind, and again at the next build.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
prepare("${CMAKE_CURRENT_LIST_DIR}/bad.jrule")

foreach(attempt 1 2)
  build(output STATUS "[1-9][0-9]*")
  expect("${output}" "/source/bad\\.jrule:[0-9]+:[0-9]+: error: [^\n]*\\[J03[0-9][0-9]\\]")
  file(GLOB_RECURSE generated "${WORK_DIR}/build/jrule/*.h" "${WORK_DIR}/build/jrule/*.cpp")
  if(generated)
    message(FATAL_ERROR "a refused rule left ${generated}")
  endif()
endforeach()

# The correction is all that it takes.
file(COPY_FILE "${CMAKE_CURRENT_LIST_DIR}/good.jrule" "${WORK_DIR}/source/bad.jrule")
build(output STATUS 0)

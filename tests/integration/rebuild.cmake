# A build compiles again what has changed, an imported module included, and nothing else.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
prepare("${CMAKE_CURRENT_LIST_DIR}/good.jrule")
set(base "${WORK_DIR}/source/shared/base.jrule")

# Some file systems keep times in seconds only.
macro(wait)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)
endmacro()

build(output STATUS 0)
expect("${output}" "Checking rules [^\n]*good\\.jrule")
expect("${output}" "Building CXX object [^\n]*good\\.cpp")
foreach(attempt 1 2)
  build(output STATUS 0)
  expect_not("${output}" "Checking|Building")
endforeach()

# A comment: the rules are checked again; as the C++ stays the same, Ninja compiles nothing.
wait()
file(APPEND "${base}" "// a comment\n")
build(output STATUS 0)
expect("${output}" "Checking rules [^\n]*good\\.jrule")
if(GENERATOR STREQUAL "Ninja")
  expect_not("${output}" "Building")
endif()
build(output STATUS 0)
expect_not("${output}" "Checking|Building")

# Another default.
wait()
file(READ "${base}" text)
string(REPLACE "Point3(0, 0, 0)" "Point3(0, 0, 7)" text "${text}")
file(WRITE "${base}" "${text}")
build(output STATUS 0)
expect("${output}" "Building CXX object [^\n]*good\\.cpp")
file(READ "${WORK_DIR}/build/jrule/rules/my/ops/good.h" header)
expect("${header}" "jrule::Point3{0\\.0, 0\\.0, 7\\.0}")
expect("${header}" "namespace my::ops")
build(output STATUS 0)
expect_not("${output}" "Checking|Building")

# A mistake in the import is reported at its place; the build recovers.
wait()
file(WRITE "${base}" "modeler Solid on gmap(3) { embedding position : vertex -> Pint3; }\n")
build(output STATUS "[1-9][0-9]*")
expect("${output}" "/shared/base\\.jrule:1:[0-9]+: error: ")
wait()
file(WRITE "${base}" "${text}")
build(output STATUS 0)

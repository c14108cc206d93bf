# examples/terrain, copied out, configured and built as its user does, and run. Only the compiler is not built again.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
file(COPY "${JRULE_SOURCE_DIR}/examples/terrain/" DESTINATION "${WORK_DIR}/source" PATTERN out EXCLUDE PATTERN build EXCLUDE)
run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DJRULE_EXECUTABLE=${JRULE}"
    "-DJRULE_SOURCE_DIR=${JRULE_SOURCE_DIR}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --target terrain)

# The same as without any C++ compiler.
run(output STATUS 0 COMMAND "${WORK_DIR}/build/terrain" landscape "${WORK_DIR}/written.jmap")
expect("${output}" "^9216 fields, 7% under water; the river ends at \\(-150, 275\\)\n$")
run(ignored STATUS 0 COMMAND "${JRULE}" run "${WORK_DIR}/source/terrain.jrule:landscape" --out "${WORK_DIR}/run.jmap")
file(READ "${WORK_DIR}/written.jmap" written)
file(READ "${WORK_DIR}/run.jmap" interpreted)
if(NOT written STREQUAL interpreted)
  message(FATAL_ERROR "terrain and `jrule run` write different maps")
endif()

# Heights from C++: the river comes down from the mountains to the fields at the southern rim, which are 25 m deep there.
run(output STATUS 0 COMMAND "${WORK_DIR}/build/terrain" massif "${WORK_DIR}/massif.off")
expect("${output}" "^2304 fields, 3% under water; the river ends at \\(-50, 275\\)\n$")
run(output STATUS 0 COMMAND "${JRULE}" info "${WORK_DIR}/massif.off")
expect("${output}" "2 401 vertices, 4 704 edges, 2 304 faces, 18 432 darts, valid\n")
run(output STATUS 1 COMMAND "${JRULE}" run "${WORK_DIR}/source/massif.jrule:massif" --out "${WORK_DIR}/none.jmap")
expect("${output}" "J0903")

run(output STATUS 2 COMMAND "${WORK_DIR}/build/terrain" lake "${WORK_DIR}/out.obj")
expect("${output}" "usage")
run(output STATUS 1 COMMAND "${WORK_DIR}/build/terrain" landscape "${WORK_DIR}/missing/out.obj")
expect("${output}" "cannot write the file")

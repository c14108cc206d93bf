# examples/cmake-consumer, copied out, configured and built as its user does, and run. Only the compiler is not built again.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
file(COPY "${JRULE_SOURCE_DIR}/examples/cmake-consumer/" DESTINATION "${WORK_DIR}/source")
run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DJRULE_EXECUTABLE=${JRULE}"
    "-DJRULE_SOURCE_DIR=${JRULE_SOURCE_DIR}" "-DBUILD_SHARED_LIBS=${SHARED}"
    "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --target refine)

file(GLOB_RECURSE shared "${WORK_DIR}/build/*/libjrule_runtime.so.0")
if(SHARED AND NOT shared OR shared AND NOT SHARED)
  message(FATAL_ERROR "BUILD_SHARED_LIBS is ${SHARED}, and shared runtimes are: ${shared}")
endif()

set(mesh "${JRULE_SOURCE_DIR}/tests/data/cube.obj")
run(output STATUS 0 COMMAND "${WORK_DIR}/build/refine" "${mesh}" "${WORK_DIR}/out.ply")
expect("${output}" "^read: 8 vertices, 12 edges, 6 faces
subdivided: 26 vertices, 48 edges, 24 faces
not applicable: `cone` is not applicable: [^\n]+
written: 26 vertices, 48 edges, 24 faces\n$")

# The same as without any C++ compiler.
file(READ "${WORK_DIR}/out.ply" written)
run(ignored STATUS 0 COMMAND "${JRULE}" apply "${WORK_DIR}/source/surface.jrule:quad_subdivision" --in "${mesh}"
    --out "${WORK_DIR}/applied.ply" --at all)
file(READ "${WORK_DIR}/applied.ply" applied)
if(NOT written STREQUAL applied)
  message(FATAL_ERROR "refine and `jrule apply` write different meshes")
endif()

run(output STATUS 1 COMMAND "${WORK_DIR}/build/refine" "${WORK_DIR}/missing.obj" "${WORK_DIR}/out.ply")
expect("${output}" "missing\\.obj")

# A user's CMake project finds the installed jrule, and has with it what it has with jrule as a subdirectory.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
copy_project()
run(ignored STATUS 0 COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_PREFIX_PATH=${PREFIX}"
    "-DJRULE_VERSION=${VERSION}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
build(ignored STATUS 0)
expect_refined("${WORK_DIR}/build/refine")
build(output STATUS 0)
expect_not("${output}" "Checking|Making|Building")
run(output STATUS 0 COMMAND "${PREFIX}/bin/jrule" info "${WORK_DIR}/build/librefine_rules.so")
expect("${output}" "^plugin refine_rules: ")
expect_refused("${WORK_DIR}/build/refine" COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/build")

# Another major version is refused.
string(REGEX MATCH "^[0-9]+" major "${VERSION}")
math(EXPR next "${major} + 1")
run(output STATUS "[1-9][0-9]*" COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/other" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DJRULE_VERSION=${next}.0")
expect("${output}" "jruleConfig\\.cmake, version: ${VERSION}")

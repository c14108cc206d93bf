# The installed compiler by itself: it takes the library installed with it, through a link too, unless the environment says
# another.
include("${CMAKE_CURRENT_LIST_DIR}/script.cmake")
copy_project()
set(jrule "${PREFIX}/bin/jrule")

# expect_library(folder COMMAND ...): what it compiles depends on the library in this folder.
function(expect_library folder)
  run(ignored STATUS 0 COMMAND ${ARGN} emit cpp "${WORK_DIR}/source/refine.jrule" -o "${WORK_DIR}/out"
      --depfile "${WORK_DIR}/refine.d")
  file(READ "${WORK_DIR}/refine.d" dependencies)
  foreach(module mesh subdivision)
    string(FIND "${dependencies}" " ${folder}/std/${module}.jrule" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "not from ${folder}:\n${dependencies}")
    endif()
  endforeach()
endfunction()

expect_library("${PREFIX}/share/jrule/stdlib" "${jrule}")
file(CREATE_LINK "${jrule}" "${WORK_DIR}/jrule" SYMBOLIC)
expect_library("${PREFIX}/share/jrule/stdlib" "${WORK_DIR}/jrule")
file(COPY "${PREFIX}/share/jrule/stdlib" DESTINATION "${WORK_DIR}")
expect_library("${WORK_DIR}/stdlib" "${CMAKE_COMMAND}" -E env "JRULE_STDLIB=${WORK_DIR}/stdlib" "${jrule}")

run(output STATUS 0 COMMAND "${jrule}" --version)
expect("${output}" "${VERSION}")

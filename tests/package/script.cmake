# What the tests of the package share. Given: PREFIX, LIBDIR, JRULE_SOURCE_DIR, JRULE_BINARY_DIR, VERSION, WORK_DIR, GENERATOR,
# CXX, LAUNCHER, MAKE, PKG_CONFIG, TBB, CPACK, DPKG_DEB.
include("${JRULE_SOURCE_DIR}/tests/integration/script.cmake")
unset(ENV{JRULE_STDLIB})

# A fresh copy of project/, as a user has it.
function(copy_project)
  file(REMOVE_RECURSE "${WORK_DIR}")
  file(COPY "${CMAKE_CURRENT_LIST_DIR}/project/" DESTINATION "${WORK_DIR}/source")
endfunction()

# expect_refined(program): it runs, and subdivides as the library of rules says.
function(expect_refined program)
  run(output STATUS 0 COMMAND "${program}" "${JRULE_SOURCE_DIR}/tests/data/cube.obj")
  expect("${output}" "^26 vertices, 48 edges, 24 faces\nat \\(0\\.222, 0\\.222, 0\\.222\\)\nnot applicable: `cone` [^\n]+\n$")
endfunction()

# expect_refused(program COMMAND ...): with a wrong rule the build fails at its line and makes no program; with the right one
# again it does.
function(expect_refused program)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "COMMAND")
  set(rules "${WORK_DIR}/source/refine.jrule")
  file(READ "${rules}" right)
  string(REPLACE "d <1,2>" "d <_,2>" wrong "${right}")
  file(REMOVE "${program}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)  # some file systems keep times in seconds only
  file(WRITE "${rules}" "${wrong}")
  run(output STATUS "[1-9][0-9]*" COMMAND ${ARG_COMMAND})
  expect("${output}" "(^|\n)[^\n]*refine\\.jrule:13:26: error: [^\n]*`d` without a 1-arc \\[J0302\\]\n")
  if(EXISTS "${program}")
    message(FATAL_ERROR "a refused rule was built into ${program}")
  endif()
  execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)
  file(WRITE "${rules}" "${right}")
  run(output STATUS 0 COMMAND ${ARG_COMMAND})
  expect_refined("${program}")
endfunction()

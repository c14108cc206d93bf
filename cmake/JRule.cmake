# For users' builds: C++ from .jrule files.
#
#   add_executable(refine main.cpp)
#   jrule_add_rules(refine RULES surface.jrule)
#
# Works alike in jrule's own tree, with jrule as a subdirectory of a project, with an installed one (find_package), and with
# the compiler of another build (-DJRULE_EXECUTABLE=…, when compiling for another machine).

set(JRULE_EXECUTABLE "" CACHE FILEPATH "The jrule compiler to run; empty: jrule::compiler")

# What all commands of the compiler share: which one it is, and its flags for these folders of imports.
function(_jrule_command compiler_variable flags_variable)
  set(flags)
  foreach(dir IN LISTS ARGN)
    get_filename_component(dir "${dir}" ABSOLUTE)
    list(APPEND flags -I "${dir}")
  endforeach()
  # With unchanged output Ninja stops there. Make compares times: it would run the compiler again for ever.
  if(CMAKE_GENERATOR MATCHES "Ninja")
    list(APPEND flags --write-if-changed)
  endif()
  if(JRULE_EXECUTABLE)
    set(${compiler_variable} "${JRULE_EXECUTABLE}" PARENT_SCOPE)
  else()
    set(${compiler_variable} jrule::compiler PARENT_SCOPE)
  endif()
  set(${flags_variable} "${flags}" PARENT_SCOPE)
endfunction()

# jrule_add_rules(target RULES file.jrule ... [IMPORT_DIRS dir ...] [NAMESPACE my::ops] [HEADER_PREFIX my/ops]
#                 [WARNINGS_AS_ERRORS])
#
# Compiles each file into <name>.h and <name>.cpp, and adds them to the target: `#include "<name>.h"`, or
# "my/ops/<name>.h" with HEADER_PREFIX. A file is compiled again when it or a module that it imports changes. A rule that
# jrule refuses stops the build at its line.
function(jrule_add_rules target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "WARNINGS_AS_ERRORS" "NAMESPACE;HEADER_PREFIX" "RULES;IMPORT_DIRS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "jrule_add_rules(${target}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT ARG_RULES)
    message(FATAL_ERROR "jrule_add_rules(${target}): RULES names no files")
  endif()

  set(include_dir "${CMAKE_CURRENT_BINARY_DIR}/jrule/${target}")
  set(output_dir "${include_dir}")
  _jrule_command(compiler flags ${ARG_IMPORT_DIRS})
  if(ARG_HEADER_PREFIX)
    string(APPEND output_dir "/${ARG_HEADER_PREFIX}")
    list(APPEND flags --header-prefix "${ARG_HEADER_PREFIX}")
  endif()
  if(ARG_NAMESPACE)
    list(APPEND flags --namespace "${ARG_NAMESPACE}")
  endif()
  if(ARG_WARNINGS_AS_ERRORS)
    list(APPEND flags -Werror)
  endif()

  foreach(rules IN LISTS ARG_RULES)
    get_filename_component(source "${rules}" ABSOLUTE)
    get_filename_component(name "${rules}" NAME_WLE)
    # In the order of the depfile: Ninja takes another first output for a depfile that is not this command's.
    set(generated "${output_dir}/${name}.h" "${output_dir}/${name}.cpp")
    add_custom_command(
      OUTPUT ${generated}
      COMMAND "${compiler}" emit cpp "${source}" -o "${output_dir}" --depfile "${output_dir}/${name}.d" ${flags}
      MAIN_DEPENDENCY "${source}"
      DEPENDS "${compiler}"
      DEPFILE "${output_dir}/${name}.d"
      COMMENT "Checking rules ${rules}"
      VERBATIM)
    target_sources(${target} PRIVATE ${generated})
    # As the interpreter computes: a*b + c is rounded twice.
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      set_property(SOURCE "${output_dir}/${name}.cpp" APPEND PROPERTY COMPILE_OPTIONS -ffp-contract=off)
    endif()
  endforeach()
  target_include_directories(${target} PRIVATE "${include_dir}")
  target_link_libraries(${target} PRIVATE jrule::runtime)
endfunction()

# jrule_add_plugin(name RULES file.jrule ... [IMPORT_DIRS dir ...] [WARNINGS_AS_ERRORS])
#
# A shared library that offers the rules of these files to programs in any language, as <jrule/plugin.h> says: to
# `jrule apply --plugin` for one. It exports `jrule_plugin_entry` and nothing else. C++ from outside that the rules use is added as
# to any target: target_sources(name PRIVATE …), target_include_directories(name PRIVATE …).
function(jrule_add_plugin target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "WARNINGS_AS_ERRORS" "" "RULES;IMPORT_DIRS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "jrule_add_plugin(${target}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT ARG_RULES)
    message(FATAL_ERROR "jrule_add_plugin(${target}): RULES names no files")
  endif()

  add_library(${target} MODULE)
  set(warnings)
  if(ARG_WARNINGS_AS_ERRORS)
    set(warnings WARNINGS_AS_ERRORS)
  endif()
  jrule_add_rules(${target} RULES ${ARG_RULES} IMPORT_DIRS ${ARG_IMPORT_DIRS} ${warnings})

  set(output_dir "${CMAKE_CURRENT_BINARY_DIR}/jrule/${target}")
  _jrule_command(compiler flags ${ARG_IMPORT_DIRS})
  list(APPEND flags --name "${target}")
  set(sources)
  set(headers)
  foreach(rules IN LISTS ARG_RULES)
    get_filename_component(source "${rules}" ABSOLUTE)
    get_filename_component(name "${rules}" NAME_WLE)
    list(APPEND sources "${source}")
    list(APPEND headers "${output_dir}/${name}.h")
  endforeach()
  # After the headers, so that what is wrong with the rules is said once.
  add_custom_command(
    OUTPUT "${output_dir}/${target}_plugin.cpp"
    COMMAND "${compiler}" emit plugin ${sources} -o "${output_dir}" --depfile "${output_dir}/${target}_plugin.d" ${flags}
    DEPENDS "${compiler}" ${sources} ${headers}
    DEPFILE "${output_dir}/${target}_plugin.d"
    COMMENT "Making the tables of the plugin ${target}"
    VERBATIM)
  target_sources(${target} PRIVATE "${output_dir}/${target}_plugin.cpp")

  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  # Hidden or not: templates of the standard library, and what is in static libraries, would be seen otherwise.
  if(APPLE)
    target_link_options(${target} PRIVATE "LINKER:-exported_symbol,_jrule_plugin_entry")
  elseif(UNIX)
    file(CONFIGURE OUTPUT "${output_dir}/exports.map" CONTENT "{ global: jrule_plugin_entry; local: *; };\n")
    target_link_options(${target} PRIVATE "LINKER:--version-script=${output_dir}/exports.map")
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${output_dir}/exports.map")
  endif()
endfunction()

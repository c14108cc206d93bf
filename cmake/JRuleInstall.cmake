# What `cmake --install` puts where. Every path is relative: an installed tree works wherever it is moved to.

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/jrule")
get_target_property(runtime_type jrule_runtime TYPE)

# The same names as in a build that has jrule as a subdirectory: jrule::runtime, jrule::compiler.
set_target_properties(jrule_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(jrule PROPERTIES EXPORT_NAME compiler)
if(runtime_type STREQUAL "SHARED_LIBRARY")
  file(RELATIVE_PATH libraries "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
  set_target_properties(jrule PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
endif()
install(TARGETS jrule jrule_runtime EXPORT jruleTargets
  RUNTIME COMPONENT jrule
  LIBRARY COMPONENT jrule
  ARCHIVE COMPONENT jrule)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/runtime/include/jrule" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT jrule FILES_MATCHING PATTERN "*.h")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/stdlib" DESTINATION "${CMAKE_INSTALL_DATADIR}/jrule"
  COMPONENT jrule FILES_MATCHING PATTERN "*.jrule")
# Under the name that Debian asks for.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT jrule RENAME copyright)

# For find_package(jrule).
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/jruleConfig.cmake.in" "${PROJECT_BINARY_DIR}/jruleConfig.cmake"
  INSTALL_DESTINATION "${package_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/jruleConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/jruleConfig.cmake" "${PROJECT_BINARY_DIR}/jruleConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/JRule.cmake" DESTINATION "${package_dir}" COMPONENT jrule)
install(EXPORT jruleTargets NAMESPACE jrule:: DESTINATION "${package_dir}" COMPONENT jrule)

# For pkg-config. Folders below the prefix are told from there, others as they are.
file(RELATIVE_PATH JRULE_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" JRULE_PREFIX "${JRULE_PREFIX}")
foreach(dir BINDIR LIBDIR INCLUDEDIR DATADIR)
  cmake_path(APPEND JRULE_${dir} "\${prefix}" "${CMAKE_INSTALL_${dir}}")
endforeach()
# A program that links the static runtime links what that uses.
set(JRULE_REQUIRES "Requires")
if(runtime_type STREQUAL "SHARED_LIBRARY")
  set(JRULE_REQUIRES "Requires.private")
endif()
set(JRULE_LIBRARIES "fmt")
if(JRULE_TBB)
  string(APPEND JRULE_LIBRARIES ", tbb")
endif()
set(JRULE_FLAGS "")
if(JRULE_SANITIZE)
  set(JRULE_FLAGS "-fsanitize=address,undefined")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/jrule.pc.in" "${PROJECT_BINARY_DIR}/jrule.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/jrule.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT jrule)

# `cpack -G DEB` in the build folder makes a Debian package of what is installed.

set(CPACK_PACKAGE_NAME jrule)
set(CPACK_PACKAGE_CONTACT "The authors of jrule")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Compiler of graph-transformation rules on generalized maps")
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};jrule;jrule;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
# What the executable needs is found out; users' programs need the headers that the runtime includes, and what it links.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libexpected-dev, libfmt-dev")
if(JRULE_TBB)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libtbb-dev")
endif()
include(CPack)

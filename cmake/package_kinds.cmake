# Read once for each kind of package: only the archive has libraries in it.
if(CPACK_GENERATOR STREQUAL "TXZ")
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_PACKAGE_DIRECTORY};temblor;libraries;/")
endif()

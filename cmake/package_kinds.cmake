# cpack reads this once for each kind of package: only the archive contains libraries, and its second part (cpack -D
# PART=light) contains nothing else.
if(CPACK_GENERATOR STREQUAL "TXZ")
  if(PART STREQUAL "light")
    set(CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_BUILD_FOLDER};temblor;light;/")
  else()
    list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_BUILD_FOLDER};temblor;libraries;/")
  endif()
  set(CPACK_POST_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/pack_harder.cmake")
endif()

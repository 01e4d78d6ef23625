# cpack reads this once for each package that tools/make_packages.sh makes. The Debian package (no PART) contains the game
# alone, the archive (PART=game) also the libraries, and the light archive (PART=light) only what the level compiler needs.
if(PART STREQUAL "game")
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_BUILD_FOLDER};temblor;libraries;/")
elseif(PART STREQUAL "light")
  set(CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_BUILD_FOLDER};temblor;light;/")
endif()

# `make install` and `make package`: the program, the shipped game, its documentation, and a menu entry. The Debian package
# depends on the libraries; the archive contains them and can be unpacked anywhere. Embree, which only the level compiler
# needs, is in a second archive, to be unpacked over the first.
include(GNUInstallDirs)

set(game_folder "${CMAKE_INSTALL_DATADIR}/games/temblor")
set(library_folder "${CMAKE_INSTALL_LIBDIR}/temblor")

# DT_RPATH instead of DT_RUNPATH, so that the libraries in the archive also find each other.
set_target_properties(temblor PROPERTIES INSTALL_RPATH "$ORIGIN/../${library_folder}")
target_link_options(temblor PRIVATE -Wl,--disable-new-dtags)
install(TARGETS temblor RUNTIME_DEPENDENCY_SET libraries COMPONENT game)

# Only files that the build makes, without saved games and settings.
install(DIRECTORY "${CMAKE_BINARY_DIR}/game/id1" DESTINATION "${game_folder}" COMPONENT game
        FILES_MATCHING REGEX "/id1/(gfx|maps|music|progs|sound)/." REGEX "/id1/(progs\\.(dat|lno)|[^/]*\\.wad|(film|start|t[0-9]|tdm[0-9]|gallery)\\.dem|quake\\.rc)$")
install(FILES "${CMAKE_BINARY_DIR}/game/id1/icon/temblor.png" COMPONENT game
        DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/256x256/apps")
# The game configuration for TrenchBroom (docs/mapping.md).
install(DIRECTORY packaging/trenchbroom DESTINATION "${game_folder}" COMPONENT game)
install(FILES "${CMAKE_BINARY_DIR}/game/id1/icon/temblor_small.png" COMPONENT game
        DESTINATION "${game_folder}/trenchbroom/Temblor" RENAME Icon.png)
install(FILES packaging/temblor.desktop COMPONENT game DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES LICENSE README.md COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# Debian requires the license under this name.
install(FILES LICENSE COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright)
# The scripts are where the documentation says (docs/compiling.md).
install(PROGRAMS docs/compile_with_parallel.sh COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs")
install(PROGRAMS packaging/compile_with_slurm.sh COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}/packaging")
# The game before and after is for readers of the sources.
install(DIRECTORY docs COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}" FILES_MATCHING PATTERN "*.md" PATTERN "*.map" PATTERN "*.png" PATTERN "*.jpg"
        PATTERN "game.md" EXCLUDE PATTERN "before_after" EXCLUDE)

# All libraries except those that come with every system: the C library, which must match the system's loader, and the
# compiler's libraries, which graphics drivers need in the system's version.
install(RUNTIME_DEPENDENCY_SET libraries COMPONENT libraries DESTINATION "${library_folder}"
        PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|stdc\\+\\+|gcc_s)\\.so"
        POST_EXCLUDE_REGEXES "/ld-linux[^/]*$")
# Remove the search paths of the libraries, because they would precede the program's.
install(CODE "file(GLOB brought \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${library_folder}/*.so*\")
foreach(library IN LISTS brought)
  if(NOT IS_SYMLINK \"\${library}\")
    file(RPATH_REMOVE FILE \"\${library}\")
  endif()
endforeach()" COMPONENT libraries)
install(FILES "$<TARGET_FILE:embree>" DESTINATION "${library_folder}" COMPONENT light
        RENAME "$<TARGET_SONAME_FILE_NAME:embree>")
# After the libraries, because it searches for their licenses.
if(EXISTS /usr/share/doc AND EXISTS /usr/bin/dpkg-query)
  set(root "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}")
  foreach(part IN ITEMS libraries light)
    install(CODE "execute_process(COMMAND \"${CMAKE_SOURCE_DIR}/tools/package_licenses.sh\" \"${root}/${library_folder}\"
                                          \"${root}/${CMAKE_INSTALL_DOCDIR}/libraries\"
                                  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${part})
  endforeach()
endif()

set(CPACK_PACKAGE_NAME temblor)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Quake-class game and engine that draws without a GPU")
set(CPACK_PACKAGE_CONTACT "Temblor's makers <temblor@localhost>")
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_FILE_NAME "temblor-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The program loads Embree at run time, so dpkg-shlibdeps does not find it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libembree${embree_VERSION_MAJOR}-${embree_VERSION_MAJOR}")
# Loaded when the player chooses OpenGL.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1")
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_SOURCE_DIR}/cmake/package_kinds.cmake")
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};temblor;game;/")
set(CPACK_BUILD_FOLDER "${CMAKE_BINARY_DIR}")  # for package_kinds.cmake
include(CPack)

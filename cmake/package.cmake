# `make install` and `make package`: the program, the game that ships with it, documents, a menu entry. The Debian
# package asks for the libraries; the archive brings them and may be unpacked anywhere. What only the map compiler needs,
# Embree, is an archive of its own, to be unpacked over the other.
include(GNUInstallDirs)

set(game_folder "${CMAKE_INSTALL_DATADIR}/games/temblor")
set(library_folder "${CMAKE_INSTALL_LIBDIR}/temblor")

# DT_RPATH, as the libraries that come along find one another by it, too.
set_target_properties(temblor PROPERTIES INSTALL_RPATH "$ORIGIN/../${library_folder}")
target_link_options(temblor PRIVATE -Wl,--disable-new-dtags)
install(TARGETS temblor RUNTIME_DEPENDENCY_SET libraries COMPONENT game)

# What is made, and nothing that playing has left there.
install(DIRECTORY "${CMAKE_BINARY_DIR}/game/id1" DESTINATION "${game_folder}" COMPONENT game
        FILES_MATCHING REGEX "/id1/(gfx|maps|music|progs|sound)/." REGEX "/id1/(progs\\.(dat|lno)|[^/]*\\.wad|(start|t[0-9]|tdm[0-9]|gallery)\\.dem|quake\\.rc)$")
install(FILES "${CMAKE_BINARY_DIR}/game/id1/icon/temblor.png" COMPONENT game
        DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/256x256/apps")
install(FILES packaging/temblor.desktop COMPONENT game DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES LICENSE README.md COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# Where Debian looks for it.
install(FILES LICENSE COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright)
install(DIRECTORY docs COMPONENT game DESTINATION "${CMAKE_INSTALL_DOCDIR}" FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.jpg")

# All but the C library's, which go with the system's loader.
install(RUNTIME_DEPENDENCY_SET libraries COMPONENT libraries DESTINATION "${library_folder}"
        PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv)\\.so" POST_EXCLUDE_REGEXES "/ld-linux[^/]*$")
# Some have a path of their own to look in, which would come before the program's.
install(CODE "file(GLOB brought \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${library_folder}/*.so*\")
foreach(library IN LISTS brought)
  if(NOT IS_SYMLINK \"\${library}\")
    file(RPATH_REMOVE FILE \"\${library}\")
  endif()
endforeach()" COMPONENT libraries)
if(EXISTS /usr/share/doc AND EXISTS /usr/bin/dpkg-query)
  set(licenses "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}/libraries")
  set(tool "${CMAKE_SOURCE_DIR}/tools/package_licenses.sh")
  install(CODE "execute_process(COMMAND \"${tool}\" \"$<TARGET_FILE:temblor>\" \"${licenses}\"
                                COMMAND_ERROR_IS_FATAL ANY)" COMPONENT libraries)
  install(CODE "execute_process(COMMAND \"${tool}\" \"$<TARGET_FILE:embree>\" \"${licenses}\"
                                COMMAND_ERROR_IS_FATAL ANY)" COMPONENT light)
endif()
install(FILES "$<TARGET_FILE:embree>" DESTINATION "${library_folder}" COMPONENT light
        RENAME "$<TARGET_SONAME_FILE_NAME:embree>")

set(CPACK_PACKAGE_NAME temblor)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Quake-class game and engine that draws without a GPU")
set(CPACK_PACKAGE_CONTACT "Temblor's makers <temblor@localhost>")
set(CPACK_GENERATOR DEB TXZ)
set(CPACK_PACKAGE_FILE_NAME "temblor-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The program opens it by itself.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libembree${embree_VERSION_MAJOR}-${embree_VERSION_MAJOR}")
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_SOURCE_DIR}/cmake/package_kinds.cmake")
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};temblor;game;/")
set(CPACK_BUILD_FOLDER "${CMAKE_BINARY_DIR}")  # for package_kinds.cmake
include(CPack)

# Run by cpack when an archive is there: packs it again with a window over all of it, as levels share their textures, for
# machine code, and for samples of two bytes. cpack cannot be told to: it packs with a window of 8 MB.
find_program(xz xz REQUIRED)
foreach(archive IN LISTS CPACK_PACKAGE_FILES)
  execute_process(COMMAND "${xz}" -dc "${archive}" COMMAND "${xz}" --x86 --lzma2=preset=9e,lp=1
                  OUTPUT_FILE "${archive}.harder" COMMAND_ERROR_IS_FATAL ANY)
  set(packed "${archive}")
  if(PART)  # made in a folder of its own, as both unpack into the same one and so have the same name
    get_filename_component(name "${archive}" NAME)
    string(REPLACE "temblor-" "temblor-${PART}-" name "${name}")
    set(packed "${CPACK_BUILD_FOLDER}/${name}")
  endif()
  file(REMOVE "${archive}")
  file(RENAME "${archive}.harder" "${packed}")
endforeach()

# cpack runs this on a finished archive. It compresses the archive again: with a window that covers all of it, because levels
# share their textures, with a filter for machine code, and with settings for two-byte samples. cpack itself always uses a
# window of 8 MB. The archive keeps its name, because cpack then copies it out of its work folder.
find_program(xz xz REQUIRED)
foreach(archive IN LISTS CPACK_PACKAGE_FILES)
  execute_process(COMMAND "${xz}" -dc "${archive}" COMMAND "${xz}" --x86 --lzma2=preset=9e,lp=1
                  OUTPUT_FILE "${archive}.harder" COMMAND_ERROR_IS_FATAL ANY)
  file(RENAME "${archive}.harder" "${archive}")
endforeach()

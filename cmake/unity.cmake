# Unity builds: g++ spends most of its time on the headers that a file includes. A unity file includes several sources, so
# those headers are read only once. `cmake -DTEMBLOR_UNITY=OFF` compiles each source separately, which is faster while you
# work on a few files.
option(TEMBLOR_UNITY "Compile large targets as unity builds" ON)
set(kFilesInAUnityFile 30)  # with more, they compile faster together, but a change of one takes longer

# temblor_unity_build(TARGET [BY_FOLDER] [FOLDERS NAME...] [APART FILE...]): compiles the target, if it exists, as a unity build.
# Names in the unnamed namespaces of one target must then differ; sources listed after APART are compiled separately. So are
# the kernel sources, which Highway includes once for each instruction set. BY_FOLDER puts the sources of one folder into
# one unity file, for a library whose folders share few headers. FOLDERS does so with the sources of these folders, and
# compiles the other sources separately.
function(temblor_unity_build target)
  if(NOT TARGET ${target})
    return()
  endif()
  cmake_parse_arguments(ARG "BY_FOLDER" "" "FOLDERS;APART" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  if(ARG_BY_FOLDER OR ARG_FOLDERS)
    foreach(source IN LISTS sources)
      get_filename_component(folder "${source}" DIRECTORY)
      get_filename_component(folder "${folder}" NAME)
      if(ARG_BY_FOLDER OR folder IN_LIST ARG_FOLDERS)
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
      endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
  list(FILTER sources INCLUDE REGEX "_simd\\.cpp$")
  set_source_files_properties(${sources} ${ARG_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TEMBLOR_UNITY} UNITY_BUILD_BATCH_SIZE ${kFilesInAUnityFile})
  if(TEMBLOR_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ treats a unity file like a header, whose types could differ between the sources that include it.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

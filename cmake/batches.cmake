# Files compiled together: most of what a file costs to compile is what it reads, and a batch reads that once.
# (`cmake -DTEMBLOR_BATCHES=OFF` compiles each by itself, for work on a few files.)
option(TEMBLOR_BATCHES "Compile the files of large targets in batches" ON)
set(kFilesABatch 14)

# temblor_batches(TARGET [BY_FOLDER] [APART FILE...]), if there is such a target: its files may be compiled together, so
# that their unnamed namespaces share no names, but for files APART. Kernel files, which highway reads once an
# instruction set, stay by themselves. BY_FOLDER: a batch is a folder, where folders have little to do with one another.
function(temblor_batches target)
  if(NOT TARGET ${target})
    return()
  endif()
  cmake_parse_arguments(ARG "BY_FOLDER" "" "APART" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  if(ARG_BY_FOLDER)
    foreach(source IN LISTS sources)
      get_filename_component(folder "${source}" DIRECTORY)
      get_filename_component(folder "${folder}" NAME)
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
  list(FILTER sources INCLUDE REGEX "_simd\\.cpp$")
  set_source_files_properties(${sources} ${ARG_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TEMBLOR_BATCHES} UNITY_BUILD_BATCH_SIZE ${kFilesABatch})
  if(TEMBLOR_BATCHES AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # To g++ a batch looks like a header, whose types other files could see differently.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

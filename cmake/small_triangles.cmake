# The drawing code of src/lab/models/small: a program of the build writes it as C++, and asmjit assembles it at run time.
set(TEMBLOR_SMALL_TRIANGLES "${CMAKE_SOURCE_DIR}/src/lab/models/small")
set(TEMBLOR_SHAPE_CODE_EXCEPT "${TEMBLOR_SMALL_TRIANGLES}/generator/write_shape_code.cpp")
if(TEMBLOR_ASMJIT_TARGET)
  list(APPEND TEMBLOR_SHAPE_CODE_EXCEPT "${TEMBLOR_SMALL_TRIANGLES}/no_assembled_shapes.cpp")
else()
  list(APPEND TEMBLOR_SHAPE_CODE_EXCEPT "${TEMBLOR_SMALL_TRIANGLES}/assembled_shapes.cpp")
endif()

# temblor_add_shape_code(TARGET): adds the C++ that the program writes.
function(temblor_add_shape_code target)
  set(sources generator/write_shape_code.cpp small_masks.cpp small_shapes.cpp)
  list(TRANSFORM sources PREPEND "${TEMBLOR_SMALL_TRIANGLES}/")
  add_executable(write_shape_code ${sources})
  target_link_libraries(write_shape_code PRIVATE temblor_flags)
  set(code "${CMAKE_BINARY_DIR}/shape_code/shape_code.cpp")
  add_custom_command(OUTPUT "${code}" COMMAND write_shape_code "${code}" DEPENDS write_shape_code VERBATIM)
  target_sources(${target} PRIVATE "${code}")
  # g++ takes 7 s with -O2, and 3 s with -O1, but that code is 10% to 20% slower. Sanitizers check every pixel inline, so
  # clang would take 11 s. A precompiled header would bring its own level of optimization.
  set(level "$<$<CONFIG:Release>:-O2>")
  if(TEMBLOR_SANITIZE)
    set(level -O0)
  endif()
  set_source_files_properties("${code}" PROPERTIES COMPILE_OPTIONS "${level}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()

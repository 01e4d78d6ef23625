# The shipped levels: game/maps/NAME.level -> levels/maps/NAME.map -> game/id1/maps/NAME.bsp, and .lit if the light has
# colors. They compile one after another, as each compilation uses all cores. The folder of the games holds nothing else,
# because the menu would list it as a mod.
set(maps_work "${CMAKE_BINARY_DIR}/levels")
set(maps_folder "${CMAKE_CURRENT_BINARY_DIR}/id1/maps")
set_property(GLOBAL APPEND PROPERTY JOB_POOLS temblor_maps=1)

file(GLOB_RECURSE texture_scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/art/textures/*.art")
file(GLOB level_scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/maps/*.level")
if(NOT texture_scripts OR NOT level_scripts)
  return()
endif()

set(textures_wad "${maps_work}/textures.wad")
add_custom_command(
  OUTPUT "${textures_wad}"
  COMMAND temblor art "${CMAKE_CURRENT_SOURCE_DIR}/art/textures" -o "${maps_work}"
  DEPENDS ${texture_scripts} "$<TARGET_FILE:temblor_artgen>"
  COMMENT "Textures"
  VERBATIM)

# Any message of the level compiler fails the build, except that boxes of supplies, b_*, have no room for a player. --clean
# ignores the .build file of another version or of a run that was killed, which would cause a message.
set(compile "\"$0\" compile --clean \"$1\" --wad \"$2\" -o \"$3\" > \"$3.txt\" 2> \"$3.err\" && ! grep -v \"$4\" \"$3.err\" || { cat \"$3.err\"; exit 1; }")
set(note_of_boxes "no entity has an origin\\|no info_player_start")
set(install_level "cp \"$0\" \"$1\" && if test -e \"$2\"; then cp \"$2\" \"$1\"; fi")
foreach(script IN LISTS level_scripts)
  get_filename_component(name "${script}" NAME_WE)
  set(map "${maps_work}/maps/${name}.map")
  set(level "${maps_work}/maps/${name}.bsp")
  set(expected "^$")
  if(name MATCHES "^b_")
    set(expected "${note_of_boxes}")
  endif()
  add_custom_command(
    OUTPUT "${map}"
    COMMAND temblor art "${script}" -o "${maps_work}"
    DEPENDS "${script}" "$<TARGET_FILE:temblor_artgen>"
    COMMENT "Map ${name}"
    VERBATIM)
  add_custom_command(
    OUTPUT "${maps_folder}/${name}.bsp"
    COMMAND sh -c "${compile}" "$<TARGET_FILE:temblor>" "${map}" "${textures_wad}" "${level}" "${expected}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${maps_folder}"
    COMMAND sh -c "${install_level}" "${level}" "${maps_folder}" "${maps_work}/maps/${name}.lit"
    DEPENDS "${map}" "${textures_wad}" "$<TARGET_FILE:temblor_compiler>"
    WORKING_DIRECTORY "${maps_work}"  # not id1, whose palette may not exist yet
    JOB_POOL temblor_maps
    COMMENT "Level ${name}"
    VERBATIM)
  list(APPEND levels "${maps_folder}/${name}.bsp")
endforeach()
add_custom_target(game_maps DEPENDS ${levels})

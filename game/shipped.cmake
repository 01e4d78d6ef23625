# The game that ships, as a base folder: build/PRESET/game with id1 in it. Art and sound come from recipes, levels from
# plans. They are made again when their text or the library that makes them has changed, not whenever the program has.
set(shipped "${CMAKE_CURRENT_BINARY_DIR}/id1")

file(GLOB_RECURSE recipes CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/art/*.recipe")
set(art_made "${CMAKE_CURRENT_BINARY_DIR}/art.made")
add_custom_command(
  OUTPUT "${art_made}"
  COMMAND temblor art "${CMAKE_CURRENT_SOURCE_DIR}/art" -o "${shipped}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${art_made}"
  DEPENDS ${recipes} "$<TARGET_FILE:temblor_artgen>"
  COMMENT "Art and sound of the shipped game"
  VERBATIM)
add_custom_target(game_art ALL DEPENDS "${art_made}")

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

# What goes on behind the first menu, and is measured: a minute of each level, played by game/player. It ends in the
# middle of the level, which is no failure.
if(NOT TEMBLOR_FTEQCC)
  add_custom_target(game_demos)
  return()
endif()
set(shown_levels t1 t2 t3)
foreach(level IN LISTS shown_levels)
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/maps/${level}.recipe")
    list(REMOVE_ITEM shown_levels ${level})
    continue()
  endif()
  set(recording "${shipped}/${level}.dem")
  add_custom_command(
    OUTPUT "${recording}"
    COMMAND sh -c "rm -f \"$2\"; \"$0\" --basedir \"$1\" --map \"$3\" --limit 60 --record \"$2\" > \"$2.txt\"; test -s \"$2\""
            "$<TARGET_FILE:game_player>" "${CMAKE_CURRENT_BINARY_DIR}" "${recording}" ${level}
    DEPENDS "${shipped}/maps/${level}.bsp" "${shipped}/progs.dat" "${art_made}"
    COMMENT "Recording of ${level}"
    VERBATIM)
  list(APPEND recordings "${recording}")
endforeach()
list(JOIN shown_levels " " names)
file(CONFIGURE OUTPUT "${shipped}/quake.rc" CONTENT "startdemos ${names}\n")
add_custom_target(game_demos ALL DEPENDS ${recordings})
add_dependencies(game_demos game_player)

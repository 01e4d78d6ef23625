# The shipped game, build/PRESET/game/id1. Art, sounds and levels are made from text files. They are made again when their
# text or the library that makes them has changed, not after every change of the program.
set(shipped "${CMAKE_CURRENT_BINARY_DIR}/id1")

file(GLOB_RECURSE scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/art/*.art")
set(art_made "${CMAKE_CURRENT_BINARY_DIR}/art.made")
add_custom_command(
  OUTPUT "${art_made}"
  COMMAND temblor art "${CMAKE_CURRENT_SOURCE_DIR}/art" -o "${shipped}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${art_made}"
  DEPENDS ${scripts} "$<TARGET_FILE:temblor_artgen>"
  COMMENT "Art and sound of the shipped game"
  VERBATIM)
add_custom_target(game_art DEPENDS "${art_made}")

if(NOT TEMBLOR_FTEQCC)
  add_custom_target(game_demos)
  return()
endif()

# A demo needs all levels: each contains items whose models are levels too, and an exit leads to another level.
file(GLOB level_scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/maps/*.level")
foreach(script IN LISTS level_scripts)
  get_filename_component(name "${script}" NAME_WE)
  list(APPEND all_levels "${shipped}/maps/${name}.bsp")
endforeach()

# temblor_demo(LEVEL FILE [OPTION...]): the scripted player plays the level with these options and records the demo
# FILE, which is kept even if the player does not reach the exit in time.
function(temblor_demo level file)
  set(play "rm -f \"$2\"; \"$0\" --basedir \"$1\" --map \"$3\" --record \"$2\" \"\${@:4}\" > \"$2.txt\"; test -s \"$2\"")
  get_filename_component(folder "${file}" DIRECTORY)
  add_custom_command(
    OUTPUT "${file}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
    COMMAND bash -c "${play}" "$<TARGET_FILE:scripted_player>" "${CMAKE_CURRENT_BINARY_DIR}" "${file}" ${level} ${ARGN}
    DEPENDS ${all_levels} "${shipped}/progs.dat" "${art_made}" scripted_player
    COMMENT "Demo of ${level}"
    VERBATIM)
endfunction()

# The demos behind the main menu show a minute of each level and a walk through the gallery. `make bench` draws the tours,
# which pass all stops and secrets, some of them under water, on their way to the exit.
set(shown_levels t1 tdm1 t2 gallery t3 tdm2 t4 start t5)
set(shown_start --tour --exit t2)
set(shown_gallery --tour --limit 105 --protocol 666)
set(shown_t2 --seed 4 --limit 60)
set(shown_t3 --seed 2 --limit 60)
set(shown_t4 --seed 4 --limit 60)
set(shown_t5 --seed 3 --limit 60)
set(shown_tdm1 --deathmatch 7 --seed 2 --limit 60)
set(shown_tdm2 --deathmatch 7 --seed 2 --limit 60)
set(tour_start --god --tour --exit t3)
foreach(level IN ITEMS t1 t2 t3 t4 t5)
  set(tour_${level} --god --secrets)
endforeach()
set(tours "${CMAKE_CURRENT_BINARY_DIR}/tours")
foreach(level IN LISTS shown_levels)
  if(NOT shown_${level})
    set(shown_${level} --limit 60)
  endif()
  temblor_demo(${level} "${shipped}/${level}.dem" ${shown_${level}})
  list(APPEND demos "${shipped}/${level}.dem")
endforeach()
foreach(level IN ITEMS start t1 t2 t3 t4 t5)
  temblor_demo(${level} "${tours}/${level}.dem" ${tour_${level}})
  list(APPEND tour_demos "${tours}/${level}.dem")
endforeach()
# The film comes first.
set(film "${shipped}/film.dem")
set(film_script "${CMAKE_CURRENT_SOURCE_DIR}/film.script")
add_custom_command(
  OUTPUT "${film}"
  COMMAND scripted_player --basedir "${CMAKE_CURRENT_BINARY_DIR}" --film "${film_script}" --record "${film}"
  DEPENDS ${all_levels} "${shipped}/progs.dat" "${art_made}" "${film_script}" scripted_player
  COMMENT "Film"
  VERBATIM)
list(APPEND demos "${film}")

list(JOIN shown_levels " " names)
file(CONFIGURE OUTPUT "${shipped}/quake.rc" CONTENT "exec default.cfg\nexec config.cfg\nexec autoexec.cfg\nstuffcmds\nstartdemos film ${names}\n")
configure_file(default.cfg "${shipped}/default.cfg" COPYONLY)
add_custom_target(game_demos DEPENDS ${demos})
add_custom_target(game_tours DEPENDS ${tour_demos})

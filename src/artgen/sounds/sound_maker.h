// The word `sound`: one file of the game's sounds.
//
//   sound weapons/rocket1i length=0.8 class=weapon
//     noise pink decay=0.6
//       lowpass 6000..300
//     tone sine pitch=120..40 decay=0.4
//
// length= is in seconds, class= says how loud (mastering.h), louder= by how many dB more than its class;
// rate= is 22050 or 44100. loop=0.5 plays on from there for ever, and the file's end leads over to it; blend=
// says for how long. fade= is how long the last of a sound takes to fall silent.
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

base::Result<std::vector<ArtPart>> make_sound_file(const ScriptLine& thing);

}  // namespace temblor::artgen

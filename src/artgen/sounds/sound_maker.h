// The ArtMaker of `sound`: one sound file of the game.
//
//   sound weapons/rocket1i length=0.8 class=weapon
//     noise pink decay=0.6
//       lowpass 6000..300
//     tone sine pitch=120..40 decay=0.4
//
// caption= describes the sound for players who cannot hear it, at most 32 characters; "-": silence. length=
// is in seconds. class= determines the loudness (mastering.h), louder= adds dB to it. rate= is 22050 or
// 44100. loop=0.5 makes the sound loop from there on; the end is blended into the loop's start over blend=
// seconds. fade= is the length of the fade at the end of a sound that does not loop.
//
//   lines -> render_patch -> remove_rumble -> halve_rate -> normalize_loudness -> fades -> 16-bit WAV
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

// Makes sound/FOLDER/NAME.wav, and a line of captions.txt (formats/game/captions.h). The random seed comes
// from the name.
base::Result<std::vector<ArtPart>> make_sound_file(const ScriptLine& asset);

}  // namespace temblor::artgen

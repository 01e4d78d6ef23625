// The ArtMakers of two-dimensional art (art.h). A drawing's lines are described in drawing.h.
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

// font NAME first=gray second=gold: a lump of gfx.wad with 256 glyphs of 8 x 8 pixels (glyphs.h).
base::Result<std::vector<ArtPart>> make_font(const ScriptLine& asset);
// picture NAME 320x200: gfx/NAME.lmp. wadpicture: a lump of gfx.wad.
base::Result<std::vector<ArtPart>> make_picture(const ScriptLine& asset);
base::Result<std::vector<ArtPart>> make_wad_picture(const ScriptLine& asset);
// pictures 24x24: a picture PREFIXNAME for every pair of a `style PREFIX` and a `drawing NAME`. A line
// `drawing` in the style marks where the drawing goes.
base::Result<std::vector<ArtPart>> make_pictures(const ScriptLine& asset);
base::Result<std::vector<ArtPart>> make_wad_pictures(const ScriptLine& asset);
// sprite progs/s_bubble.spr 16x16 facing=view: an SPR file; each `frame` line contains a drawing.
base::Result<std::vector<ArtPart>> make_sprite(const ScriptLine& asset);
// icon NAME 256: the true-color picture icon/NAME.png with this side, drawn in 64 x 64 coordinates.
base::Result<std::vector<ArtPart>> make_icon(const ScriptLine& asset);
// mark NAME 64x64: the true-color picture gfx/marks/NAME.png, which levels and game code show on walls.
base::Result<std::vector<ArtPart>> make_mark(const ScriptLine& asset);

}  // namespace temblor::artgen

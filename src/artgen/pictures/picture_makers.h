// The words of 2-D art: font, picture, wadpicture, pictures, wadpictures, sprite, icon.
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

// font NAME first=gray second=gold: a lump of gfx.wad with 256 glyphs of 8 x 8 (pictures/glyphs.h)
base::Result<std::vector<ArtPart>> make_font(const ScriptLine& thing);
// picture NAME 320x200: gfx/NAME.lmp; wadpicture: a lump of gfx.wad (pictures/drawing.h)
base::Result<std::vector<ArtPart>> make_picture(const ScriptLine& thing);
base::Result<std::vector<ArtPart>> make_wad_picture(const ScriptLine& thing);
// pictures 24x24: every `drawing NAME` in every `style PREFIX`, whose line `drawing` stands for it.
base::Result<std::vector<ArtPart>> make_pictures(const ScriptLine& thing);
base::Result<std::vector<ArtPart>> make_wad_pictures(const ScriptLine& thing);
// sprite progs/s_bubble.spr 16x16 facing=view: a drawing in each `frame`.
base::Result<std::vector<ArtPart>> make_sprite(const ScriptLine& thing);
// icon NAME 256: icon/NAME.png of that side, drawn on 64 x 64 pixels.
base::Result<std::vector<ArtPart>> make_icon(const ScriptLine& thing);

}  // namespace temblor::artgen

// The shipped game's files, made from scripts: the same bytes every time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/scripts/script.h"
#include "base/bytes.h"
#include "base/parallel_for.h"
#include "base/result.h"

namespace temblor::artgen {

// What a thing becomes: a file of the game folder, or a lump of a WAD there.
struct ArtPart {
  std::string path;  // "progs/knight.mdl", "gfx.wad"
  base::ByteVector bytes;
  std::string lump = {};       // empty: the file itself
  std::uint8_t lump_type = 0;  // as in formats::WadLump
};

// What makes one kind of things, those whose line begins with `word`. Errors begin with the line
// (script_error).
struct ArtMaker {
  std::string_view word;
  base::Result<std::vector<ArtPart>> (*make)(const ScriptLine& thing);
};
std::span<const ArtMaker> art_makers();

struct ScriptFile {
  std::string name;  // for messages
  std::vector<ScriptLine> things;
};

struct ArtFile {
  std::string path;
  base::ByteVector bytes;
};

// Palette, colormap and what the scripts' things become, in the order of their paths. A kind of things that
// is not known, and two things that want to be the same file or lump, are errors, which name the script's
// file.
base::Result<std::vector<ArtFile>> make_art(std::span<const ScriptFile> scripts, base::Jobs& jobs);

}  // namespace temblor::artgen

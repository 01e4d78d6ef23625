// Builds the shipped game's files from scripts. The same scripts produce the same bytes on every machine.
//
//   .art and .level scripts, as text
//     | read_script (scripts/script.h)
//   ScriptLines: a tree of keywords, values, and settings for each asset
//     | expand_parts (scripts/parts.h) replaces the "use NAME" lines
//     | an ArtMaker, chosen by the asset's keyword; assets are made in parallel
//   ArtParts: whole files, or lumps of a WAD
//     | grouped by path, lumps by name
//   ArtFiles
//
// The makers are in textures, models, pictures, sounds, and level_script. They need the writers of `formats`
// and no other part of the engine. docs/art-scripts.md and docs/level-scripts.md describe the languages.
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

// A result of an asset: a file of the game directory, a lump of a WAD there, or a line of a text file.
struct ArtPart {
  // Relative to the game directory: "progs/knight.mdl", "gfx.wad".
  std::string path;
  base::ByteVector bytes;
  // The lump's name, or what orders the line among those of a text file. Empty: `bytes` is the whole file.
  std::string lump = {};
  // The type of a formats::WadLump; unused for files.
  std::uint8_t lump_type = 0;
};

// Makes the assets whose line begins with `keyword`. A maker is a pure function of the line, so that makers
// can run in parallel. Its errors begin with the line's number (script_error).
struct ArtMaker {
  std::string_view keyword;
  base::Result<std::vector<ArtPart>> (*make)(const ScriptLine& asset);
};
// All makers, in the order that error messages list them.
std::span<const ArtMaker> art_makers();

// A parsed script file.
struct ScriptFile {
  // For error messages.
  std::string name;
  // The lines at the left edge: assets and parts.
  std::vector<ScriptLine> assets;
};

struct ArtFile {
  std::string path;
  base::ByteVector bytes;
};

// Makes the palette, the colormap, and all assets of the scripts, and returns the files in the order of their
// paths. Parts may be used before they are defined, also from other scripts. Fails for an unknown keyword,
// for two assets that make the same file or lump, and for a path that is both a file and a WAD. Errors name
// the script file and the line.
base::Result<std::vector<ArtFile>> make_art(std::span<const ScriptFile> scripts, base::Jobs& jobs);

}  // namespace temblor::artgen

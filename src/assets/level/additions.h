// Files next to a level that replace parts of it:
//
//   maps/NAME.ent   entity text
//   maps/NAME.vis   visibility, for transparent water (formats/levels/vis_patch.h)
//   maps/NAME.lit   colored light
//
// One that cannot be read or was made for another version of the level is ignored, with a note.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::assets {

struct Addition {
  std::string name;                      // in messages
  base::Result<base::ByteVector> bytes;  // errors name the file
};
// Reads the file next to the level with this suffix (".ent"); nullopt: there is none.
using AdditionReader = std::function<std::optional<Addition>(std::string_view suffix)>;

struct Additions {
  std::optional<formats::Lit> lit;  // if it matches the level
  std::string entities_file;        // in messages; empty: the level's own entities
};

// Replaces the entity text and visibility of the level `name`, and returns the rest.
Additions apply_additions(const AdditionReader& read, std::string_view name, formats::Bsp& io_bsp,
                          std::vector<std::string>& io_notes);

}  // namespace temblor::assets

// The model of a sheet, from a file of any of the formats that the game draws.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "math/vec.h"
#include "render/alias_model.h"

namespace temblor::app {

struct SheetFrame {
  std::string name;  // may be empty
  math::Bounds box;  // around the vertices of its first pose, in the model's space
};

struct SheetModel {
  std::shared_ptr<const render::AliasModel> model;
  std::vector<SheetFrame> frames;  // at least one
};

// Reads an .mdl, .md3, or .md5mesh. The skins of the latter two, the .md5anim, and the palette for TGA and
// PNG skins are looked up next to it, as in a game directory. Adds a line to `io_notes` for each skin that is
// missing. Errors name the file.
base::Result<SheetModel> read_sheet_model(const std::filesystem::path& file,
                                          std::vector<std::string>& io_notes);

}  // namespace temblor::app

#include "assets/level/additions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "formats/levels/entities.h"
#include "formats/levels/vis_patch.h"

namespace temblor::assets {
namespace {

// Keeps the entities around a fault in the text, as the level's own text is read. The text ends at its first
// zero.
base::Status replace_entities(const std::string& file, base::Bytes bytes, formats::Bsp& io_bsp,
                              std::vector<std::string>& io_notes) {
  std::string_view text = base::as_text(bytes);
  text = text.substr(0, text.find('\0'));
  const formats::EntityText read = formats::read_faulty_entities(text);
  if (read.entities.empty() || read.entities[0].classname() != "worldspawn")
    return base::malformed("the first entity is not worldspawn");
  if (!read.first_fault.empty()) io_notes.push_back(fmt::format("{}: {}", file, read.first_fault));
  io_bsp.entities = read.first_fault.empty() ? std::string(text) : formats::write_entities(read.entities);
  return base::Ok{};
}

base::Status replace_visibility(base::Bytes bytes, std::string_view level, formats::Bsp& io_bsp) {
  TRY(const std::vector<formats::VisPatch> patches, formats::read_vis_patches(bytes));
  const std::string level_file = base::to_lower(fmt::format("{}.bsp", level));
  const auto patch = std::ranges::find_if(patches, [&](const formats::VisPatch& candidate) {
    return base::to_lower(candidate.level) == level_file;
  });
  if (patch == patches.end()) return base::malformed("there is no patch for {}", base::printable(level_file));
  return formats::apply_vis_patch(*patch, io_bsp);
}

base::Result<formats::Lit> read_matching_lit(base::Bytes bytes, const formats::Bsp& bsp) {
  TRY(formats::Lit lit, formats::read_lit(bytes));
  if (lit.samples.size() != bsp.lighting.size() * 3)
    return base::malformed("{} bytes of light, but this version of the level needs {}", lit.samples.size(),
                           bsp.lighting.size() * 3);
  return lit;
}

}  // namespace

Additions apply_additions(const AdditionReader& read, std::string_view name, formats::Bsp& io_bsp,
                          std::vector<std::string>& io_notes) {
  Additions additions;
  // Calls `apply` with the file's bytes, if there is one, and notes a failure of either.
  const auto apply_file = [&](std::string_view suffix, std::string_view consequence, const auto& apply) {
    const std::optional<Addition> file = read(suffix);
    if (!file) return;
    base::Status status =
        file->bytes.ok() ? apply(file->name, *file->bytes) : base::Status(file->bytes.error());
    status = std::move(status).with_file(file->name);
    if (!status.ok()) io_notes.push_back(fmt::format("{}; {}", status.error().message(), consequence));
  };
  apply_file(".ent", "these entities are ignored",
             [&](const std::string& file, base::Bytes bytes) -> base::Status {
               TRY_STATUS(replace_entities(file, bytes, io_bsp, io_notes));
               additions.entities_file = file;
               return base::Ok{};
             });
  apply_file(".vis", "this visibility is ignored",
             [&](const std::string&, base::Bytes bytes) { return replace_visibility(bytes, name, io_bsp); });
  apply_file(".lit", "colored light is ignored", [&](const std::string&, base::Bytes bytes) -> base::Status {
    TRY(additions.lit, read_matching_lit(bytes, io_bsp));
    return base::Ok{};
  });
  return additions;
}

}  // namespace temblor::assets

// A base folder with one game made in code: id1 with a palette and the level "small".
#pragma once

#include "artgen/palette.h"
#include "base/check.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "support/levels/small_bsp.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

class SmallGame {
 public:
  // The level that the program draws if there is no --map and no other option.
  explicit SmallGame(const artgen::SmallLevelOptions& options = {.colored_light = true})
      : level_(small_bsp(options)) {
    folder_.write("id1/gfx/palette.lmp", formats::write_palette(artgen::make_palette()));
    folder_.write("id1/maps/small.bsp", level_bytes(formats::BspVersion::k29));
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  const TemporaryFolder& folder() const { return folder_; }
  const formats::Bsp& level() const { return level_; }
  base::ByteVector level_bytes(formats::BspVersion version) const {
    return formats::write_bsp(level_, version).value();
  }

 private:
  TemporaryFolder folder_;
  formats::Bsp level_;
};

}  // namespace temblor::test

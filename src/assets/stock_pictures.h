// The pictures that every game comes with, by name, and how large LibreQuake's are: what a stand-in for a
// missing one has to know.
#pragma once

#include <cstdint>
#include <span>

namespace temblor::assets {

struct StockPicture {
  const char* name;             // as Pictures::find() takes it
  std::uint16_t width, height;  // pixels
};

// Those of gfx.wad, and those that are files of their own.
std::span<const StockPicture> stock_wad_pictures();
std::span<const StockPicture> stock_picture_files();

}  // namespace temblor::assets

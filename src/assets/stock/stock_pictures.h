// The pictures that every stock game has, with their sizes in LibreQuake, for placeholders of missing ones.
#pragma once

#include <cstdint>
#include <span>

namespace temblor::assets {

struct StockPicture {
  const char* name;             // as for Pictures::find()
  std::uint16_t width, height;  // pixels
};

// The pictures in gfx.wad, and the pictures in separate files.
std::span<const StockPicture> stock_wad_pictures();
std::span<const StockPicture> stock_picture_files();

}  // namespace temblor::assets

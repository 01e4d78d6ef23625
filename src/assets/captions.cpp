#include "assets/captions.h"

#include <fmt/format.h>

#include <utility>

namespace temblor::assets {

formats::Captions load_captions(const vfs::FileSystem& files, std::vector<std::string>& io_notes) {
  formats::Captions all;
  for (const vfs::FileSystem::Layer& layer : files.read_layers("captions.txt")) {
    if (!layer.bytes.ok()) {
      io_notes.push_back(layer.bytes.error().message());
      continue;
    }
    formats::Captions read = formats::read_captions(base::as_text(*layer.bytes));
    for (const std::size_t line : read.bad_lines)
      io_notes.push_back(
          fmt::format("{}:{}: expected a sound's file and its caption: dog/dattack1.wav dog snarls",
                      layer.description, line));
    read.texts.merge(all.texts);
    all.texts = std::move(read.texts);
  }
  return all;
}

}  // namespace temblor::assets

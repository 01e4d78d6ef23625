// Feeds arbitrary bytes to the PAK reader. It must return an error, or entries inside the archive whose
// files are written and read back unchanged.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "formats/archives/pak.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_pak(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  const auto entries = formats::read_pak(bytes);
  if (!entries.ok()) return 0;
  std::vector<formats::ArchiveFile> files;
  for (const formats::PakEntry& entry : *entries)
    files.push_back({entry.name.substr(0, formats::kPakNameChars), bytes.subspan(entry.offset, entry.size)});
  const auto written = formats::write_pak(files);
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_pak(*written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->size() == files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    CHECK((*back)[i].name == files[i].name);
    CHECK(
        std::ranges::equal(base::Bytes(*written).subspan((*back)[i].offset, (*back)[i].size), files[i].data));
  }
  return 0;
}

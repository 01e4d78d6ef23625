// Feeds arbitrary bytes to the PK3 reader. It must return an error, or entries that unpack or return an
// error each, and that are packed and read back unchanged.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/check.h"
#include "formats/archives/pk3.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_pk3(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  // A low limit makes the target spend its time on the directory and not on unpacking.
  const formats::Pk3Limits limits{.unpacked_bytes = 4 << 20};
  const auto pk3 = formats::read_pk3({bytes.begin(), bytes.end()}, limits);
  if (!pk3.ok()) return 0;
  std::vector<base::ByteVector> contents;
  std::vector<formats::ArchiveFile> files;
  std::set<std::string> names;
  contents.reserve(pk3->entries().size());
  for (std::size_t i = 0; i < pk3->entries().size(); ++i) {
    auto unpacked = pk3->read(i);
    if (!unpacked.ok() || !names.insert(pk3->entries()[i].name).second) continue;
    CHECK(unpacked->size() == pk3->entries()[i].size);
    contents.push_back(std::move(unpacked).value());
    files.push_back({pk3->entries()[i].name, contents.back()});
  }
  if (files.empty()) return 0;
  auto written = formats::write_pk3(files);
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_pk3(std::move(written).value(), limits);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->entries().size() == files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    CHECK(back->entries()[i].name == files[i].name);
    const auto unpacked = back->read(i);
    CHECK(unpacked.ok(), "{}", unpacked.error().message());
    CHECK(*unpacked == contents[i]);
  }
  return 0;
}

// Feeds arbitrary bytes with correct hashes to the reader of build files, next to a small level. The reader
// must return an error or a build that is written as the same bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "base/hash.h"
#include "compiler/build_file.h"
#include "formats/levels/bsp.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

// One empty leaf besides the solid one, and one face.
formats::Bsp small_level() {
  formats::Bsp bsp;
  bsp.planes.push_back({{0, 0, 1}, 0, 2});
  bsp.leaves.resize(2);
  bsp.leaves[0].contents = -2;
  bsp.leaves[1].contents = -1;
  formats::BspNode node;
  node.children = {-2, -1};
  bsp.nodes.push_back(node);
  bsp.models.emplace_back().visible_leaves = 1;
  return bsp;
}

}  // namespace

int temblor::fuzz::fuzz_build(const std::uint8_t* data, std::size_t size) {
  const auto bsp = formats::write_bsp(small_level(), formats::BspVersion::k29);
  CHECK(bsp.ok() && formats::read_bsp(*bsp).ok());
  const compiler::LevelFiles files{*bsp, {}};
  // A build file starts with the hashes of the level's files and ends with a hash of everything. The input
  // replaces the bytes between them.
  constexpr std::size_t kStartBytes = 24;
  base::ByteWriter writer;
  writer.bytes(base::Bytes(compiler::write_build({}, files)).first(kStartBytes));
  writer.bytes(std::as_bytes(std::span(data, size)));
  writer.write(base::hash_bytes(writer.view()));
  const base::ByteVector bytes = std::move(writer).take();
  const auto build = compiler::read_build(bytes, files);
  if (build.ok()) {
    const base::ByteVector again = compiler::write_build(*build, files);
    const auto back = compiler::read_build(again, files);
    CHECK(back.ok(), "{}", back.error().message());
    CHECK(std::ranges::equal(compiler::write_build(*back, files), again));
  }
  return 0;
}

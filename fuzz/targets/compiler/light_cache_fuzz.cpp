// Feeds arbitrary bytes, with and without a correct hash at the end, to the reader of light caches. It must
// return an error, or a cache that is written as the same bytes and whose shadow records can be queried.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/check.h"
#include "base/hash.h"
#include "compiler/light/light_cache.h"
#include "compiler/light/shadows/shadow_record.h"
#include "fuzz/targets.h"

namespace {

using namespace temblor;

void ask_shadows(base::Bytes record, std::size_t luxels) {
  std::vector<std::uint32_t> all(luxels);
  std::iota(all.begin(), all.end(), 0u);
  compiler::ShadowReader reader(record, luxels);
  for (std::uint32_t light = 0; light < 64; ++light)
    if (const auto answer = reader.find({light, all, false})) CHECK(answer->size() == luxels);
}

void expect_stable(base::Bytes bytes) {
  const auto cache = compiler::read_light_cache(bytes);
  if (!cache.ok()) return;
  const base::ByteVector written = compiler::write_light_cache(*cache);
  CHECK(std::ranges::equal(written, bytes));
  for (const compiler::LightCache::Map& map : cache->maps)
    for (const std::size_t luxels : {std::size_t{1}, std::size_t{9}, std::size_t{100}})
      ask_shadows(map.shadows, luxels);
}

}  // namespace

int temblor::fuzz::fuzz_light_cache(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  expect_stable(bytes);
  base::ByteWriter writer;
  writer.bytes(bytes);
  writer.write(base::hash_bytes(bytes));
  expect_stable(writer.view());
  return 0;
}

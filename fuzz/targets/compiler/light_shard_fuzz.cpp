// Feeds arbitrary bytes to the reader of light shards, for a small level. It must return an error or light
// that is written as the same bytes.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "compiler/light/shard_file.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

const std::vector<std::size_t> kLuxelsOfMap{4, 1, 6, 9};

compiler::LightWork nothing_done() {
  compiler::LightWork work;
  work.light.resize(kLuxelsOfMap.size());
  work.is_lit.resize(kLuxelsOfMap.size());
  work.bounces.begin_of_face = {0, 2, 2, 5};
  work.bounces.seen.resize(5);
  work.bounces.is_traced.resize(3);
  return work;
}

}  // namespace

int temblor::fuzz::fuzz_light_shard(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  compiler::LightWork work = nothing_done(), again = nothing_done();
  const auto shard = compiler::read_shard(bytes, kLuxelsOfMap, work);
  if (!shard.ok()) return 0;
  const base::ByteVector written = compiler::write_shard(shard->header, work);
  // Any byte except 0 means true for "has dirt" and "is lit".
  CHECK(written.size() == bytes.size());
  const auto back = compiler::read_shard(written, kLuxelsOfMap, again);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->header == shard->header && back->is_finished == shard->is_finished);
  CHECK(again.is_lit == work.is_lit && again.bounces.is_traced == work.bounces.is_traced);
  return 0;
}

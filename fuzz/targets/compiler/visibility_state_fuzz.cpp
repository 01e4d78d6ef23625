// Feeds arbitrary bytes, with and without a correct hash at the end, to the reader of visibility states. It
// must return an error or a state that is written as the same bytes, except for the flags of portals that do
// not exist.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "base/hash.h"
#include "compiler/vis/visibility.h"
#include "compiler/vis/visibility_state.h"
#include "fuzz/targets.h"

namespace {

using temblor::compiler::PortalSet;
using temblor::compiler::VisibilityState;

// Two rooms with an opening. The 70 clusters need two words per row.
VisibilityState two_rooms() {
  PortalSet set;
  set.cluster_count = 70;
  set.portals.push_back({{{0, 0, 0}, {0, 0, 9}, {0, 9, 9}, {0, 9, 0}}, {1, 0, 0}, 0, {0, 1}});
  return temblor::compiler::begin_visibility(set);
}

void expect_stable(temblor::base::Bytes bytes, const VisibilityState& begun) {
  const auto state = temblor::compiler::read_visibility_state(bytes, begun);
  if (!state.ok()) return;
  const auto written = temblor::compiler::write_visibility_state(*state);
  CHECK(written.size() == bytes.size());
  CHECK(temblor::compiler::read_visibility_state(written, begun).value() == *state);
}

}  // namespace

int temblor::fuzz::fuzz_visibility_state(const std::uint8_t* data, std::size_t size) {
  static const VisibilityState begun = two_rooms();
  const auto bytes = std::as_bytes(std::span(data, size));
  expect_stable(bytes, begun);
  temblor::base::ByteWriter writer;
  writer.bytes(bytes);
  std::uint64_t hash = size;
  for (const std::byte byte : bytes) hash = temblor::base::hash_with(hash, static_cast<std::uint64_t>(byte));
  writer.write(hash);
  expect_stable(writer.view(), begun);
  return 0;
}

// Any bytes as a shard of a small level's light: an error, or light that is written as those bytes again.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "compiler/light/shard_file.h"

using namespace temblor;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::size_t> luxels_of_face{4, 1, 6, 9};
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  auto shard = compiler::read_shard(bytes, luxels_of_face);
  if (!shard.ok()) return 0;
  std::vector<compiler::FaceLight> light(luxels_of_face.size());
  for (auto& [face, face_light] : shard->maps) light.at(face) = std::move(face_light);
  const base::ByteVector written = compiler::write_shard(shard->header, light);
  // Whether there is dirt is any byte but 0.
  CHECK(written.size() == bytes.size());
  const auto back = compiler::read_shard(written, luxels_of_face);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->header == shard->header && back->maps.size() == shard->maps.size());
  return 0;
}

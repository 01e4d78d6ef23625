// Feeds arbitrary text to the entity reader. It must return an error, or entities that are written and read
// back unchanged.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "formats/levels/entities.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_entities(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto entities = temblor::formats::read_entities(text);
  if (!entities.ok()) return 0;
  for (const auto& entity : *entities) {
    static_cast<void>(entity.find_number("angle"));
    static_cast<void>(entity.find_vec3("origin"));
  }
  const auto back = temblor::formats::read_entities(temblor::formats::write_entities(*entities));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *entities);
  return 0;
}

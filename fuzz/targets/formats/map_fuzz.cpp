// Feeds arbitrary text to the MAP reader. It must return an error that names a line, or a map that is
// written and read back unchanged, except for line numbers.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "formats/levels/map.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

formats::Map without_lines(formats::Map map) {
  for (formats::MapEntity& entity : map.entities) {
    entity.line = 0;
    for (formats::MapBrush& brush : entity.brushes) {
      brush.line = 0;
      for (formats::MapSide& side : brush.sides) side.line = 0;
    }
  }
  return map;
}

}  // namespace

int temblor::fuzz::fuzz_map(const std::uint8_t* data, std::size_t size) {
  const auto map = formats::read_map({reinterpret_cast<const char*>(data), size});
  if (!map.ok()) {
    CHECK(map.error().what.find("line ") != std::string::npos, "{}", map.error().what);
    return 0;
  }
  const auto back = formats::read_map(formats::write_map(*map));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(without_lines(*back) == without_lines(*map));
  return 0;
}

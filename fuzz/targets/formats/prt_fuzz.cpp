// Feeds arbitrary text to the PRT reader. It must return an error or portals that are written and read back
// as the same portals.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/levels/prt.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_prt(const std::uint8_t* data, std::size_t size) {
  const auto file = temblor::formats::read_prt(base::as_text(std::as_bytes(std::span(data, size))));
  if (!file.ok()) return 0;
  for (const formats::PrtPortal& portal : file->portals)
    for (const std::uint32_t cluster : portal.clusters) CHECK(cluster < file->cluster_count);
  const auto again = formats::read_prt(formats::write_prt(*file));
  CHECK(again.ok() && *again == *file);
  return 0;
}

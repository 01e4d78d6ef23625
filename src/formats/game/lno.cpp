#include "formats/game/lno.h"

#include <array>

namespace temblor::formats {
namespace {

constexpr std::string_view kLnoMagic = "LNOF";
constexpr std::uint32_t kLnoVersion = 1;
constexpr std::size_t kLnoHeaderBytes = 24, kLineBytes = 4;

}  // namespace

base::Result<std::vector<std::uint32_t>> read_lno(base::Bytes bytes, const Progs& progs) {
  base::ByteReader reader(bytes);
  if (bytes.size() < kLnoHeaderBytes || base::as_text(reader.take(kLnoMagic.size())) != kLnoMagic)
    return base::malformed("not a line number file: it does not start with \"{}\" and a header", kLnoMagic);
  if (const std::uint32_t version = reader.u32(); version != kLnoVersion)
    return base::error(base::ErrorCode::kUnsupported, "line numbers of version {} are not supported, only {}",
                       version, kLnoVersion);
  for (const std::size_t count :
       {progs.globals.size(), progs.global_words.size(), progs.fields.size(), progs.statements.size()})
    if (const std::uint32_t here = reader.u32(); here != count)
      return base::malformed(
          "line numbers belong to another program: count {}, expected {}; compile the program again", here,
          count);
  if (reader.remaining() < progs.statements.size() * kLineBytes)
    return base::malformed("line numbers of {} statements: {} bytes are missing", progs.statements.size(),
                           progs.statements.size() * kLineBytes - reader.remaining());
  std::vector<std::uint32_t> lines(progs.statements.size());
  for (std::uint32_t& line : lines) line = reader.u32();
  return lines;
}

}  // namespace temblor::formats

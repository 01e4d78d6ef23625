#include "support/programs/quakespasm_folder.h"

#include <algorithm>
#include <vector>

#include "formats/archives/pak.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

constexpr const char* kProgram = "/usr/games/quakespasm";
constexpr std::size_t kPictureBytes = 256, kAlignment = 32;

// 16 x 16 texels: a dark background, and sixty to a hundred texels from one row of the palette.
bool looks_like_it(base::Bytes bytes) {
  std::size_t painted = 0;
  for (const std::byte byte : bytes) {
    const auto texel = static_cast<unsigned>(byte);
    if (texel != 0 && (texel < 0x60 || texel > 0x6f)) return false;
    painted += texel != 0 ? 1 : 0;
  }
  return painted > 60 && painted < 200;
}

// The program stores it as 16-bit numbers, whose bytes are swapped in the file.
std::optional<base::ByteVector> find_picture(base::Bytes program) {
  for (std::size_t at = 0; at + kPictureBytes <= program.size(); at += kAlignment) {
    const base::Bytes bytes = program.subspan(at, kPictureBytes);
    if (!looks_like_it(bytes)) continue;
    base::ByteVector picture(bytes.begin(), bytes.end());
    for (std::size_t i = 0; i < picture.size(); i += 2) std::swap(picture[i], picture[i + 1]);
    return picture;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::filesystem::path> make_quakespasm_folder(const TemporaryFolder& folder,
                                                            const std::filesystem::path& data,
                                                            const std::filesystem::path& progs) {
  if (!std::filesystem::exists(kProgram)) return std::nullopt;
  const base::ByteVector program = read_file(kProgram);
  const std::optional<base::ByteVector> picture = find_picture(program);
  if (!picture) return std::nullopt;
  const std::vector<formats::ArchiveFile> files = {{"gfx/pop.lmp", *picture}};
  folder.write("base/id1/pak0.pak", formats::write_pak(files).value());
  folder.write("base/id1/quake.rc", "stuffcmds\n");
  folder.write("base/id1/progs.dat", read_file(progs));
  const std::filesystem::path base = folder.path() / "base";
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1")) {
    const std::filesystem::path link = base / "id1" / entry.path().filename();
    if (entry.path().extension() != ".dem" && !std::filesystem::exists(link))
      std::filesystem::create_symlink(entry.path(), link);
  }
  return base;
}

}  // namespace temblor::test

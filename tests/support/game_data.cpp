#include "support/game_data.h"

#include <cstdlib>
#include <fstream>

#include "base/check.h"

namespace temblor::test {

std::optional<std::filesystem::path> data_folder() {
  const char* value = std::getenv("TEMBLOR_DATA");
  if (value == nullptr || !std::filesystem::is_directory(std::filesystem::path(value) / "id1"))
    return std::nullopt;
  return std::filesystem::path(value);
}

base::ByteVector read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  CHECK(file.good(), "cannot read {}", path.string());
  base::ByteVector bytes(static_cast<std::size_t>(std::filesystem::file_size(path)));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  CHECK(file.good(), "cannot read {}", path.string());
  return bytes;
}

}  // namespace temblor::test

#include "support/programs/temporary_folder.h"

#include <stdlib.h>

#include <fstream>
#include <string>
#include <system_error>

#include "base/check.h"

namespace temblor::test {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "temblor-test-XXXXXX").string();
  CHECK(mkdtemp(name.data()) != nullptr, "cannot make {}", name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(std::string_view name, base::Bytes bytes) const {
  const std::filesystem::path path = path_ / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  CHECK(file.good(), "cannot write {}", path.string());
  return path;
}

std::filesystem::path TemporaryFolder::write(std::string_view name, std::string_view text) const {
  return write(name, base::as_bytes(text));
}

}  // namespace temblor::test

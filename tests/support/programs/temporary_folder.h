// A folder of its own for a test, gone with all that is in it when the object is.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/bytes.h"

namespace temblor::test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  // Writes a file, making the folders on the way; `name` is relative to path(). CHECKs that it can.
  std::filesystem::path write(std::string_view name, base::Bytes bytes) const;
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace temblor::test

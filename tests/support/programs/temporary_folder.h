// A temporary folder for a test. The destructor deletes it with its contents.
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

  // Writes a file, and makes its folders. `name` is relative to path(). CHECKs that it succeeds.
  std::filesystem::path write(std::string_view name, base::Bytes bytes) const;
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace temblor::test

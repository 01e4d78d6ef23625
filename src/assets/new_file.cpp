#include "assets/new_file.h"

#include "vfs/disk.h"

namespace temblor::assets {

base::Result<base::ByteVector> read_new_file(const vfs::FileSystem& files, const std::string& name) {
  if (files.contains(name)) return files.read(name);
  for (auto folder = files.folders().rbegin(); folder != files.folders().rend(); ++folder)
    if (base::Result<base::ByteVector> bytes = vfs::read_disk_file(*folder / name); bytes.ok()) return bytes;
  return base::ByteVector{};
}

}  // namespace temblor::assets

#include "formats/models/md5/joints.h"

#include <fmt/format.h>

#include "formats/models/md5.h"

namespace temblor::formats {

constexpr std::int32_t kVersion = 10;

void read_md5_header(Md5Scanner& io_scanner) {
  io_scanner.expect("MD5Version");
  io_scanner.whole_number(kVersion, kVersion);
  if (io_scanner.accept("commandline")) io_scanner.word();
}

Md5Joint read_md5_joint(Md5Scanner& io_scanner, std::size_t number) {
  Md5Joint joint;
  joint.name = io_scanner.word();
  joint.parent = io_scanner.whole_number(-1, static_cast<std::int32_t>(kMaxMd5Joints) - 1);
  // No cycles: parents come first.
  if (joint.parent >= static_cast<std::int32_t>(number)) {
    io_scanner.fail(
        fmt::format("the parent of joint {} is joint {}, not an earlier one or -1", number, joint.parent));
    joint.parent = -1;
  }
  return joint;
}

}  // namespace temblor::formats

// The parts that both MD5 files have.
#pragma once

#include <cstddef>

#include "formats/models/md5.h"
#include "formats/models/md5/scanner.h"

namespace temblor::formats {

// MD5Version 10, and the exporter's command line if there is one.
void read_md5_header(Md5Scanner& io_scanner);

// "NAME" PARENT of joint `number`. The parent must be an earlier joint, which excludes cycles.
Md5Joint read_md5_joint(Md5Scanner& io_scanner, std::size_t number);

}  // namespace temblor::formats

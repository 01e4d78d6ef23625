// Replaces assembled_shapes.cpp where there is no asmjit, or another kind of processor.
#include "lab/models/small/assembled_shapes.h"

namespace temblor::lab {

struct AssembledShapes::Code {};

AssembledShapes::AssembledShapes(std::unique_ptr<Code> code) : code_(std::move(code)) {}
AssembledShapes::~AssembledShapes() = default;
AssembledShapes::AssembledShapes(AssembledShapes&&) noexcept = default;
AssembledShapes& AssembledShapes::operator=(AssembledShapes&&) noexcept = default;

bool make_executable(void* /*memory*/, std::size_t /*bytes*/) {
  return false;
}

base::Result<AssembledShapes> AssembledShapes::make(std::span<const std::uint32_t> /*masks*/,
                                                    MakeExecutable /*protect*/) {
  return base::error(base::ErrorCode::kUnsupported,
                     "compiled-triangles:code=1 needs an x86-64 processor, and a Temblor that was built with "
                     "asmjit (Debian package libasmjit-dev)");
}

std::span<const DrawShape> AssembledShapes::indexed() const {
  return {};
}
std::span<const DrawShape> AssembledShapes::rgb() const {
  return {};
}
std::size_t AssembledShapes::size_bytes() const {
  return 0;
}

}  // namespace temblor::lab

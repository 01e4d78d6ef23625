// Drawing code for each shape of a small triangle, assembled for x86-64 at run time by asmjit, a library of
// the zlib license (https://asmjit.com): no loop and no mask, and each pixel has its distance from the first
// one in its instructions.
//
// All shapes are assembled at once into one block of memory, which is writable first and executable then,
// never both.
#pragma once

#include <memory>
#include <span>

#include "base/result.h"
#include "lab/models/small/built_shapes.h"

namespace temblor::lab {

// Makes memory executable and no longer writable. Returns whether the system allows it.
using MakeExecutable = bool (*)(void* memory, std::size_t bytes);
bool make_executable(void* memory, std::size_t bytes);

// Never changes; any number of threads may run the code.
class AssembledShapes {
 public:
  // Skins with more columns or rows than this have to be drawn by something else: s and t are 16-bit numbers.
  static constexpr std::int32_t kMaxSkinSide = 32767;

  // By shape. Fails with kUnsupported if there is no asmjit in this program, or if the system refuses
  // executable memory; with kTooLarge if memory runs out.
  static base::Result<AssembledShapes> make(std::span<const std::uint32_t> masks,
                                            MakeExecutable protect = make_executable);
  ~AssembledShapes();
  AssembledShapes(AssembledShapes&&) noexcept;
  AssembledShapes& operator=(AssembledShapes&&) noexcept;

  std::span<const DrawShape> indexed() const;
  std::span<const DrawShape> rgb() const;
  std::size_t size_bytes() const;

 private:
  struct Code;
  explicit AssembledShapes(std::unique_ptr<Code> code);
  std::unique_ptr<Code> code_;
};

}  // namespace temblor::lab

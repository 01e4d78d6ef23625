#include "lab/models/small/assembled_shapes.h"

#include <asmjit/x86.h>

#include <bit>
#include <cstddef>
#include <vector>

#include "base/check.h"
#include "lab/models/small/small_masks.h"

namespace temblor::lab {

namespace {

namespace x86 = asmjit::x86;

// Registers that a function may change without saving them.
constexpr x86::Gp kDrawing = x86::rdi, kWidth = x86::rsi, kDepth = x86::r8, kPixels = x86::r9,
                  kSkin = x86::r10, kColors = x86::r11, kTexel = x86::rax, kLight = x86::rcx,
                  kPixelBefore = x86::rdx;
constexpr x86::Xmm kColumns[] = {x86::xmm0, x86::xmm1, x86::xmm2, x86::xmm3, x86::xmm4};
constexpr x86::Xmm kRow = x86::xmm5, kRight = x86::xmm6, kDown = x86::xmm7, kValues = x86::xmm8,
                   kTinted = x86::xmm9, kZero = x86::xmm10, kBefore = x86::xmm11, kPixelDepth = x86::xmm12,
                   kNearest = x86::xmm13;

constexpr x86::Mem field(std::size_t offset) {
  return x86::ptr(kDrawing, static_cast<std::int32_t>(offset));
}

// Wrong instructions are mistakes of ours.
class Failures : public asmjit::ErrorHandler {
 public:
  void handleError(asmjit::Error, const char* message, asmjit::BaseEmitter*) override {
    CHECK(false, "{}", message);
  }
};

// SSE2 only, which every x86-64 processor has.
class ShapeAssembler {
 public:
  explicit ShapeAssembler(asmjit::CodeHolder& io_code) : to_(&io_code) {
    ones_ = embed(0x3f800000);        // 1.0f
    half_words_ = embed(0x40004000);  // 16384
    one_words_ = embed(0x00010001);
  }

  // The function's label.
  asmjit::Label add_shape(std::uint32_t mask, bool is_indexed) {
    to_.align(asmjit::AlignMode::kCode, 16);
    const asmjit::Label label = to_.newLabel();
    to_.bind(label);
    begin(mask);
    for (int row = 0; mask != 0; ++row, mask >>= SmallMasks::kMaxSide) {
      if (row > 0) step_down(is_indexed);
      if ((mask & kTopRow) == 0) continue;
      to_.movaps(kRow, kDown);
      to_.mulps(kRow, field(offsetof(SmallDrawing, per_row)));
      for (std::uint32_t left = mask & kTopRow; left != 0; left &= left - 1)
        add_pixel(std::countr_zero(left), is_indexed);
    }
    to_.ret();
    return label;
  }

 private:
  static constexpr std::uint32_t kTopRow = 0b11111;

  asmjit::Label embed(std::uint32_t value) {
    to_.align(asmjit::AlignMode::kData, 16);
    const asmjit::Label label = to_.newLabel();
    to_.bind(label);
    for (int lane = 0; lane < 4; ++lane) to_.embedUInt32(value);
    return label;
  }

  void begin(std::uint32_t mask) {
    std::uint32_t columns = 0;
    for (std::uint32_t left = mask; left != 0; left >>= SmallMasks::kMaxSide) columns |= left & kTopRow;
    to_.mov(kDepth, field(offsetof(SmallDrawing, depth)));
    to_.mov(kPixels, field(offsetof(SmallDrawing, pixels)));
    to_.mov(kSkin, field(offsetof(SmallDrawing, skin)));
    to_.mov(kColors, field(offsetof(SmallDrawing, colors)));
    if (mask > kTopRow) to_.mov(kWidth, field(offsetof(SmallDrawing, width)));
    to_.pxor(kZero, kZero);
    to_.movaps(kDown, field(offsetof(SmallDrawing, down)));
    to_.movaps(kRight, field(offsetof(SmallDrawing, right)));
    for (std::size_t column = 0; columns >> column != 0; ++column) {
      if (column > 0) to_.addps(kRight, x86::ptr(ones_));
      if ((columns >> column & 1) == 0) continue;
      to_.movaps(kColumns[column], kRight);
      to_.mulps(kColumns[column], field(offsetof(SmallDrawing, per_column)));
      to_.addps(kColumns[column], field(offsetof(SmallDrawing, at_a)));
    }
  }

  void step_down(bool is_indexed) {
    to_.addps(kDown, x86::ptr(ones_));
    to_.lea(kDepth, x86::ptr(kDepth, kWidth, 2));
    to_.lea(kPixels, x86::ptr(kPixels, kWidth, is_indexed ? 0 : 2));
  }

  // Pixels that are hidden are computed, too, and not stored: which ones are hidden cannot be predicted, and
  // a wrong prediction takes longer.
  void add_pixel(int column, bool is_indexed) {
    const x86::Mem depth = x86::dword_ptr(kDepth, 4 * column);
    to_.movaps(kValues, kColumns[column]);
    to_.addps(kValues, kRow);
    to_.movss(kBefore, depth);
    to_.movaps(kPixelDepth, kValues);
    to_.movaps(kNearest, kValues);
    to_.maxss(kNearest, kBefore);  // the second if one is not a number
    to_.movss(depth, kNearest);
    to_.minps(kValues, field(offsetof(SmallDrawing, most)));
    to_.maxps(kValues, kZero);
    to_.cvttps2dq(kValues, kValues);
    to_.packssdw(kValues, kValues);
    if (!is_indexed) to_.pshuflw(kTinted, kValues, 0b01010101);
    // Light to the lower half, and the texel's number to the upper half.
    to_.pmaddwd(kValues, field(offsetof(SmallDrawing, skin_steps)));
    to_.movq(kTexel, kValues);
    is_indexed ? add_indexed(column) : add_rgb(column);
  }

  void add_indexed(int column) {
    const x86::Mem pixel = x86::byte_ptr(kPixels, column);
    to_.mov(kLight.r32(), kTexel.r32());
    to_.shr(kTexel, 32);
    to_.mov(kLight.r8(), x86::byte_ptr(kSkin, kTexel));  // row * 256 + texel
    to_.movzx(kTexel.r32(), x86::byte_ptr(kColors, kLight));
    to_.movzx(kPixelBefore.r32(), pixel);
    to_.comiss(kPixelDepth, kBefore);
    to_.cmovb(kTexel.r32(), kPixelBefore.r32());
    to_.mov(pixel, kTexel.r8());
  }

  // This is lit_color() of render/alias/affine_triangle.h, with all channels at once.
  void add_rgb(int column) {
    const x86::Mem pixel = x86::dword_ptr(kPixels, 4 * column);
    const asmjit::Label is_bright = to_.newLabel();
    to_.shr(kTexel, 32);
    to_.movzx(kTexel.r32(), x86::byte_ptr(kSkin, kTexel));
    to_.mov(kTexel.r32(), x86::dword_ptr(kColors, kTexel, 2));
    to_.cmp(kTexel.r32(), 0x01000000);
    to_.short_().jb(is_bright);
    to_.paddw(kTinted, kTinted);
    to_.pmulhuw(kTinted, field(offsetof(SmallDrawing, tint)));  // light * tint / 32768
    to_.punpcklwd(kTinted, x86::ptr(half_words_));
    to_.movd(kValues, kTexel.r32());
    to_.punpcklbw(kValues, kZero);
    to_.paddw(kValues, kValues);
    to_.punpcklwd(kValues, x86::ptr(one_words_));
    to_.pmaddwd(kValues, kTinted);  // twice the color * tinted light + 16384
    to_.psrad(kValues, 15);
    to_.packssdw(kValues, kValues);
    to_.packuswb(kValues, kValues);
    to_.movd(kTexel.r32(), kValues);
    to_.bind(is_bright);
    to_.or_(kTexel.r32(), 0xff000000);
    to_.comiss(kPixelDepth, kBefore);
    to_.cmovb(kTexel.r32(), pixel);
    to_.mov(pixel, kTexel.r32());
  }

  x86::Assembler to_;
  asmjit::Label ones_, half_words_, one_words_;
};

std::size_t round_up_to_pages(std::size_t bytes) {
  const std::size_t page = asmjit::VirtMem::info().pageSize;
  return (bytes + page - 1) / page * page;
}

}  // namespace

struct AssembledShapes::Code {
  void* memory = nullptr;
  std::size_t bytes = 0;
  std::vector<DrawShape> indexed, rgb;

  Code() = default;
  Code(const Code&) = delete;
  Code& operator=(const Code&) = delete;
  ~Code() {
    if (memory != nullptr) asmjit::VirtMem::release(memory, bytes);
  }
};

AssembledShapes::AssembledShapes(std::unique_ptr<Code> code) : code_(std::move(code)) {}
AssembledShapes::~AssembledShapes() = default;
AssembledShapes::AssembledShapes(AssembledShapes&&) noexcept = default;
AssembledShapes& AssembledShapes::operator=(AssembledShapes&&) noexcept = default;

bool make_executable(void* memory, std::size_t bytes) {
  return asmjit::VirtMem::protect(memory, bytes, asmjit::VirtMem::MemoryFlags::kAccessRX) == asmjit::kErrorOk;
}

base::Result<AssembledShapes> AssembledShapes::make(std::span<const std::uint32_t> masks,
                                                    MakeExecutable protect) {
  asmjit::CodeHolder code;
  Failures failures;
  code.init(asmjit::Environment::host());
  code.setErrorHandler(&failures);
  ShapeAssembler assembler(code);
  std::vector<asmjit::Label> indexed, rgb;
  for (const std::uint32_t mask : masks) indexed.push_back(assembler.add_shape(mask, true));
  for (const std::uint32_t mask : masks) rgb.push_back(assembler.add_shape(mask, false));
  code.flatten();
  code.resolveUnresolvedLinks();

  auto made = std::make_unique<Code>();
  made->bytes = round_up_to_pages(code.codeSize());
  if (asmjit::VirtMem::alloc(&made->memory, made->bytes, asmjit::VirtMem::MemoryFlags::kAccessRW) !=
      asmjit::kErrorOk)
    return base::error(base::ErrorCode::kTooLarge, "there is not enough memory to assemble drawing code");
  code.relocateToBase(reinterpret_cast<std::uintptr_t>(made->memory));
  code.copyFlattenedData(made->memory, made->bytes);
  if (!protect(made->memory, made->bytes))
    return base::error(base::ErrorCode::kUnsupported,
                       "this system refuses memory for code that is made at run time, which "
                       "compiled-triangles:code=1 needs");
  const auto find_function = [&](const asmjit::Label& label) {
    return reinterpret_cast<DrawShape>(static_cast<char*>(made->memory) + code.labelOffset(label));
  };
  for (const asmjit::Label& label : indexed) made->indexed.push_back(find_function(label));
  for (const asmjit::Label& label : rgb) made->rgb.push_back(find_function(label));
  return AssembledShapes(std::move(made));
}

std::span<const DrawShape> AssembledShapes::indexed() const {
  return code_->indexed;
}
std::span<const DrawShape> AssembledShapes::rgb() const {
  return code_->rgb;
}
std::size_t AssembledShapes::size_bytes() const {
  return code_->bytes;
}

}  // namespace temblor::lab

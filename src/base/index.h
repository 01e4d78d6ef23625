// Typed indices into arrays: `enum class FaceIndex : std::uint32_t {}` cannot be mixed up with a LeafIndex.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace temblor::base {

template <typename T>
concept IndexType = std::is_enum_v<T> && std::same_as<std::underlying_type_t<T>, std::uint32_t>;

// Convert between an index and a position in an array. Positions must be below 2^32.
template <IndexType Index>
constexpr std::size_t to_size(Index index) {
  return static_cast<std::size_t>(static_cast<std::uint32_t>(index));
}

template <IndexType Index>
constexpr Index to_index(std::size_t position) {
  return static_cast<Index>(static_cast<std::uint32_t>(position));
}

}  // namespace temblor::base

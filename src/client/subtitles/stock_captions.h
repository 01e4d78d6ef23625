// Captions of the sounds of stock Quake.
#pragma once

#include <optional>
#include <string_view>

namespace temblor::client {

// The caption of a stock sound, "dog/dattack1.wav"; empty for silence. Nothing if the sound is unknown.
std::optional<std::string_view> find_stock_caption(std::string_view sound);

}  // namespace temblor::client

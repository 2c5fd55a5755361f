// Letters of a UTF-8 text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pathrace {

/// Bytes of the letter that `text` begins with: 1 to 4, or 0 when it begins with no UTF-8.
std::size_t letter_size(std::string_view text);
/// The character that `size` bytes spell, `size` as letter_size gives it and at least 1.
std::uint32_t code_point(std::string_view text, std::size_t size);
/// Number of letters; a byte that is no UTF-8 counts as one.
std::size_t letter_count(std::string_view text);
/// The text in so many letters, at least 1: an ellipsis stands for the middle of a longer one.
std::string shortened(std::string_view text, std::size_t letters);

}  // namespace pathrace

// Numbers as text that reads back bit for bit.
//
// A double is printed in the shortest decimals that read back as the same number; a NaN, which has no such
// decimals, as "nan:" and its sixteen hexadecimal digits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pathrace::results {

void append_number(std::string& text, double value);
std::string print_number(double value);

/// Each throws InputError that quotes the text.
double parse_number(std::string_view text);
std::uint64_t parse_count(std::string_view text);
/// Sixteen lower-case hexadecimal digits, as hex() prints them.
std::uint64_t parse_hex(std::string_view text);

}  // namespace pathrace::results

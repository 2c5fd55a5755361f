// Pictures of maps: PGM, PPM and PBM, PNG, BMP. The first bytes say which, not the name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scenarios/image/grey_image.hpp"

namespace pathrace::scenarios {

/// Throws InputError "FILE: the value, what was expected" (with the line, where a file has lines) for what is
/// no picture, a damaged one, or one larger than a map may be; EnvironmentError when the machine refuses.
GreyImage read_image(const std::filesystem::path& file);
/// The same for bytes at hand; `name` stands for the file.
GreyImage parse_image(std::string_view bytes, const std::string& name);

/// Netpbm: P1 and P4 (bits), P2 and P5 (grey), P3 and P6 (colour), any greatest value from 1 to 65535, `#`
/// comments. The samples must be as many as the header says; behind them nothing but blanks, and behind
/// binary samples that begin with a blank not even those. https://netpbm.sourceforge.net/doc/pgm.html
GreyImage parse_pnm(std::string_view bytes, const std::string& name);

/// PNG of any colour type and depth, interlaced or not; 1, 2 and 4-bit greys count as shares of 255, `tRNS`
/// counts as alpha, gamma is not applied. Refused before it is decoded when its compressed bytes cannot hold
/// its pixels. By libpng.
GreyImage parse_png(std::string_view bytes, const std::string& name);

/// BMP without compression: 1, 4 or 8-bit palettes, 24 or 32 bits, bottom-up and top-down. The fourth byte
/// of 32 bits is alpha only where the header has a mask for it.
GreyImage parse_bmp(std::string_view bytes, const std::string& name);

}  // namespace pathrace::scenarios

// A canvas as a PNG file.
#pragma once

#include <string>

#include "results/raster.hpp"

namespace pathrace::results {

/// 8 bits each of red, green and blue; no time stamps, so equal canvases give equal bytes. Throws
/// EnvironmentError with libpng's own words.
std::string png_bytes(const Canvas& canvas);

}  // namespace pathrace::results

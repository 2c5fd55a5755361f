// A picture as map_server sees it: how bright each pixel is.
//
// map_server takes the mean of the colour channels, without weights. The sample of a pixel is the sum of its
// channels, as they stand in the file, and `white` is the greatest sum there can be: brightness is sample /
// white exactly, at any depth (for a 16-bit RGB picture white is 3 * 65535). Row 0 is the top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pathrace::scenarios {

struct GreyImage {
  int width = 0;
  int height = 0;
  std::uint32_t white = 255;           ///< the brightest sample, at least 1
  std::vector<std::uint32_t> samples;  ///< width * height, row by row, each 0..white
  std::uint16_t opaque = 0;            ///< the alpha of an opaque pixel; 0: the picture has no alpha
  std::vector<std::uint16_t> alpha;    ///< as many as samples, each 0..opaque; empty without alpha

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace pathrace::scenarios

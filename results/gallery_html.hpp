// The gallery as one HTML page.
#pragma once

#include <ostream>
#include <vector>

#include "results/gallery.hpp"

namespace pathrace::results {

/// A self-contained page, well-formed as XML too: style and pictures are inside, nothing is fetched, nothing
/// runs. Neighbouring tiles with the same title share a card. Light or dark as the reader's system is.
void write_gallery_html(std::ostream& out, const std::vector<Tile>& tiles);

}  // namespace pathrace::results

#include "core/distance_transform.hpp"

#include <algorithm>
#include <cmath>

namespace pathrace {
namespace {

constexpr std::int64_t far_column = std::int64_t{1} << 20;  // its square is `far`

// Distance along the column to the nearest blocked cell, for every cell of the padded width.
std::vector<std::int64_t> column_distances(const OccupancyGrid& grid, Border border) {
  const std::size_t stride = grid.stride();
  const std::int64_t outside = border == Border::blocked ? 0 : far_column;
  std::vector<std::int64_t> distance(grid.padded_size(), outside);
  for (int y = 0; y < grid.height(); ++y) {
    const std::size_t first = grid.index({0, y});
    for (std::size_t i = first; i < first + stride - 2; ++i) {
      distance[i] = grid.blocked_at(i) ? 0 : distance[i - stride] + 1;
    }
  }
  for (std::size_t i = distance.size() - stride; i-- > 0;) {
    distance[i] = std::min(distance[i], distance[i + stride] + 1);
  }
  return distance;
}

// For one row: squared distance of each x = min over u of (x - u)^2 + column[u]^2, by the lower envelope.
class RowEnvelope {
 public:
  explicit RowEnvelope(std::size_t width) : apex_(width), from_(width) {}

  void transform(const std::int64_t* column, std::int64_t width, std::int64_t* squared) {
    const auto value = [&](std::int64_t x, std::int64_t u) {
      return (x - u) * (x - u) + column[u] * column[u];
    };
    std::int64_t top = 0;
    apex(0) = 0;
    from(0) = 0;
    for (std::int64_t u = 1; u < width; ++u) {
      while (top >= 0 && value(from(top), apex(top)) > value(from(top), u)) --top;
      if (top < 0) {
        top = 0;
        apex(0) = u;
        continue;
      }
      const std::int64_t v = apex(top);
      const std::int64_t numerator = u * u - v * v + column[u] * column[u] - column[v] * column[v];
      const std::int64_t takes_over = 1 + floor_divide(numerator, 2 * (u - v));
      if (takes_over < width) {
        ++top;
        apex(top) = u;
        from(top) = takes_over;
      }
    }
    for (std::int64_t x = width - 1; x >= 0; --x) {
      squared[x] = value(x, apex(top));
      if (x == from(top)) --top;
    }
  }

 private:
  static std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
  }
  std::int64_t& apex(std::int64_t i) { return apex_[static_cast<std::size_t>(i)]; }
  std::int64_t& from(std::int64_t i) { return from_[static_cast<std::size_t>(i)]; }

  std::vector<std::int64_t> apex_;
  std::vector<std::int64_t> from_;
};

}  // namespace

DistanceTransform::DistanceTransform(const OccupancyGrid& grid, Border border)
    : width_(static_cast<std::size_t>(grid.width())),
      squared_(width_ * static_cast<std::size_t>(grid.height())) {
  const std::vector<std::int64_t> column = column_distances(grid, border);
  const std::size_t stride = grid.stride();
  std::vector<std::int64_t> row(stride);
  RowEnvelope envelope(stride);
  for (std::size_t y = 0; y < static_cast<std::size_t>(grid.height()); ++y) {
    envelope.transform(column.data() + (y + 1) * stride, static_cast<std::int64_t>(stride), row.data());
    std::copy_n(row.begin() + 1, width_, squared_.begin() + static_cast<std::ptrdiff_t>(y * width_));
  }
}

double DistanceTransform::distance(Cell cell) const {
  return std::sqrt(static_cast<double>(squared(cell)));
}

}  // namespace pathrace

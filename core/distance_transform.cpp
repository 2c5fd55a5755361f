#include "core/distance_transform.hpp"

#include <algorithm>
#include <cmath>

#include "core/checkpoint.hpp"

namespace pathrace {
namespace {

constexpr std::int32_t far_column = std::int32_t{1} << 20;  // its square is `far`

// Distance along the column to the nearest blocked cell, for every cell of the padded width.
std::vector<std::int32_t> column_distances(const OccupancyGrid& grid, Border border) {
  const std::size_t stride = grid.stride();
  const std::int32_t outside = border == Border::blocked ? 0 : far_column;
  std::vector<std::int32_t> distance;
  assign_gradually(distance, grid.padded_size(), outside);
  for (int y = 0; y < grid.height(); ++y) {
    checkpoint();
    const std::size_t first = grid.index({0, y});
    for (std::size_t i = first; i < first + stride - 2; ++i) {
      distance[i] = grid.blocked_at(i) ? 0 : distance[i - stride] + 1;
    }
  }
  for (int y = grid.height() - 1; y >= -1; --y) {
    checkpoint();
    const std::size_t first = grid.index({-1, y});
    for (std::size_t i = first; i < first + stride; ++i) {
      distance[i] = std::min(distance[i], distance[i + stride] + 1);
    }
  }
  return distance;
}

// For one row: squared distance of each x = min over u of (x - u)^2 + column[u]^2, by the lower envelope.
class RowEnvelope {
 public:
  explicit RowEnvelope(std::size_t width) : apex_(width), from_(width) {}

  void transform(const std::int32_t* column, std::int64_t width, std::int64_t* squared) {
    const auto square = [column](std::int64_t u) { return std::int64_t{column[u]} * column[u]; };
    const auto value = [&](std::int64_t x, std::int64_t u) { return (x - u) * (x - u) + square(u); };
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
      const std::int64_t numerator = u * u - v * v + square(u) - square(v);
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
      squared_(filled_gradually<std::vector<std::uint32_t>>(width_ * static_cast<std::size_t>(grid.height()),
                                                            beyond)) {
  const std::vector<std::int32_t> column = column_distances(grid, border);
  const std::size_t stride = grid.stride();
  std::vector<std::int64_t> row(stride);
  RowEnvelope envelope(stride);
  for (std::size_t y = 0; y < static_cast<std::size_t>(grid.height()); ++y) {
    checkpoint();
    envelope.transform(column.data() + (y + 1) * stride, static_cast<std::int64_t>(stride), row.data());
    std::transform(row.begin() + 1, row.end() - 1, squared_.begin() + static_cast<std::ptrdiff_t>(y * width_),
                   [](std::int64_t squared) {
                     return static_cast<std::uint32_t>(std::min<std::int64_t>(squared, beyond));
                   });
  }
}

double DistanceTransform::distance(Cell cell) const {
  return std::sqrt(static_cast<double>(squared(cell)));
}

}  // namespace pathrace

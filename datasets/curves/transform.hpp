#pragma once

#include <Eigen/Geometry>
#include <string_view>

#include "datasets/text.hpp"

namespace kappabench {

/// Of the plane.
using AffineMap = Eigen::Affine2d;

/// The value of an SVG attribute `transform`: a list of matrix, translate, scale, rotate, skewX and skewY, the last one
/// applied first (SVG 2, 8.5). Empty is the identity. Throws DataError.
[[nodiscard]] AffineMap parse_transform(std::string_view text, const Place& place);

}  // namespace kappabench

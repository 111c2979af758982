// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/plane_fit.h"

namespace alidade::meshing {
namespace {

/// Makes a symmetric matrix diagonal; the columns of `vectors` are its eigenvectors. Jacobi's method: G. Golub, C. Van Loan, "Matrix Computations", 8.5.
void diagonalise(Mat3& m, Mat3& vectors) {
    vectors = Mat3(1.0);
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (std::abs(m[q][p]) <= 1e-300) continue;
                const double theta = (m[q][q] - m[p][p]) / (2 * m[q][p]), t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                Mat3 turn(1.0);
                turn[p][p] = turn[q][q] = c, turn[q][p] = s, turn[p][q] = -s;
                m = glm::transpose(turn) * m * turn;
                vectors = vectors * turn;
            }
}

}  // namespace

void PlaneFit::add(const Vec3& point, const Vec3& normal) {
    planes_.emplace_back(point, normal);
    sum_ += point;
}

Vec3 PlaneFit::nearest() const {
    constexpr double kFree = 0.1;
    const Vec3 mean = sum_ / double(planes_.size());
    Mat3 squares(0.0), vectors;
    Vec3 right(0);
    for (const auto& [point, normal] : planes_) {
        squares += glm::outerProduct(normal, normal);
        right += dot(normal, point - mean) * normal;
    }
    diagonalise(squares, vectors);
    const double largest = std::max({squares[0][0], squares[1][1], squares[2][2]});
    Vec3 out = mean;
    for (int i = 0; i < 3; ++i)
        if (squares[i][i] > kFree * largest) out += dot(vectors[i], right) / squares[i][i] * vectors[i];
    return out;
}

}  // namespace alidade::meshing

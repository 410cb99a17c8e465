// The stationary covariance of a Kalman filter of three states. Freestanding.
#pragma once

namespace breakaway {

/// A 3 × 3 matrix without a library, for boards that have none.
template <typename Scalar>
struct Matrix3 {
  Scalar at[3][3] = {};

  static constexpr Matrix3 identity() {
    Matrix3 one;
    for (int k = 0; k < 3; ++k) one.at[k][k] = Scalar(1);
    return one;
  }
  constexpr Matrix3 transposed() const {
    Matrix3 out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) out.at[i][j] = at[j][i];
    }
    return out;
  }
  /// By the adjugate; the caller sees to it that there is one.
  constexpr Matrix3 inverse() const {
    Matrix3 out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
        out.at[i][j] = at[a][c] * at[b][d] - at[a][d] * at[b][c];
      }
    }
    const Scalar determinant = at[0][0] * out.at[0][0] + at[0][1] * out.at[1][0] + at[0][2] * out.at[2][0];
    for (auto& row : out.at) {
      for (Scalar& value : row) value /= determinant;
    }
    return out;
  }
  friend constexpr Matrix3 operator+(const Matrix3& a, const Matrix3& b) {
    Matrix3 out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) out.at[i][j] = a.at[i][j] + b.at[i][j];
    }
    return out;
  }
  friend constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    Matrix3 out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) out.at[i][j] += a.at[i][k] * b.at[k][j];
      }
    }
    return out;
  }
};

/// P of x' = F·x + w, y = x₀ + v with cov w = Q, var v = r > 0: the solution of
/// P = F·P·Fᵀ − F·P·hᵀ·(h·P·hᵀ + r)⁻¹·h·P·Fᵀ + Q, the covariance of the prediction. By doubling, each step of which
/// does the work of all before it: Chu, Fan, Lin, "A structure-preserving doubling algorithm for continuous-time
/// algebraic Riccati equations", Linear Algebra Appl. 396, 2005, sec. 2, on the dual equation. Needs (F, x₀) observable
/// and every state driven by Q or stable.
template <typename Scalar>
constexpr Matrix3<Scalar> stationaryCovariance(const Matrix3<Scalar>& F, const Matrix3<Scalar>& Q, Scalar r) {
  Matrix3<Scalar> A = F.transposed(), G, H = Q;
  G.at[0][0] = Scalar(1) / r;
  for (int k = 0; k < 40; ++k) {
    const Matrix3<Scalar> middle = (Matrix3<Scalar>::identity() + G * H).inverse();
    const Matrix3<Scalar> growth = A.transposed() * H * middle * A;
    const Matrix3<Scalar> next = A * middle;
    G = G + next * G * A.transposed();
    H = H + growth;
    A = next * A;
    Scalar trace = 0, grown = 0;
    for (int i = 0; i < 3; ++i) trace += H.at[i][i], grown += growth.at[i][i];
    if (grown <= Scalar(1e-14) * trace) break;
  }
  return H;
}

}  // namespace breakaway

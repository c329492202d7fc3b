// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/element_frequency.hpp"

#include <Eigen/Eigenvalues>

namespace corpuscle::fabric {

double highest_frequency_squared(const CornerMatrix& stiffness, const double* mass) {
    CornerMatrix k = stiffness;
    for (Eigen::Index i = 0; i < k.rows(); ++i)
        for (Eigen::Index j = 0; j < k.cols(); ++j) k(i, j) /= std::sqrt(mass[i / 2] * mass[j / 2]);
    const Eigen::SelfAdjointEigenSolver<CornerMatrix> modes(k, Eigen::EigenvaluesOnly);
    return modes.eigenvalues().maxCoeff();
}

}  // namespace corpuscle::fabric

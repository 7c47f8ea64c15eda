// In a file of its own, because Eigen's templates compile slowly: under sanitizers they take minutes.
#include "tests/support/eigenvalues.h"

#include <Eigen/Eigenvalues>

std::vector<double> eigenvalues(int n, const std::vector<double> &symmetric) {
    Eigen::Map<const Eigen::MatrixXd> matrix(symmetric.data(), n, n);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    return {solver.eigenvalues().data(), solver.eigenvalues().data() + n};
}

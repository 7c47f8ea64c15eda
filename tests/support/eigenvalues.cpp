// In a file of its own, because Eigen's templates compile slowly: under sanitizers they take minutes.
#include "tests/support/eigenvalues.h"

#include <Eigen/Eigenvalues>

double besideBestSubspace(const float *values, int rows, int columns, int dimensions) {
    using RowByRow = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::MatrixXd a = Eigen::Map<const RowByRow>(values, rows, columns).cast<double>(), gram;
    a.rowwise() -= a.colwise().mean().eval();
    if (columns > rows)
        gram = a * a.transpose();
    else
        gram = a.transpose() * a;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().head(gram.rows() - dimensions).cwiseMax(0).sum();
}

// Symmetric sparse systems of 6 × 6 blocks, one row of blocks for each member.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <utility>
#include <vector>

namespace fff {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Block6 = Eigen::Matrix<double, 6, 6>;

/// The lower triangle, and its factors. The pattern is settled once; values are written into it in
/// place, and the symbolic factors stay.
///
/// Source  T. Davis 2006, Direct methods for sparse linear systems, chapter 4 (up-looking LDLᵀ) and
///         P. Amestoy, T. Davis, I. Duff 1996 (approximate minimum degree), both as Eigen has them.
class BlockSystem
{
public:
    /// count members, with a block for each of these pairs (any order, repeated or not).
    BlockSystem(int count, const std::vector<std::pair<int, int>> &pairs);

    int size() const { return static_cast<int>(m_matrix.rows()); }
    /// All values 0.
    void clear();
    /// Adds to the block of one member; of a symmetric block.
    void addDiagonal(int member, const Block6 &block);
    /// Adds to the block in the rows of a and the columns of b, one of the pairs; its transpose is
    /// the block of b and a.
    void addCoupling(int a, int b, const Block6 &block);
    Eigen::VectorXd diagonal() const;
    void addToDiagonal(const Eigen::VectorXd &values);
    /// All values in the order of the pattern; the factors stay what they were.
    Eigen::VectorXd values() const;
    void setValues(const Eigen::VectorXd &values);

    /// Factors of what the values are now; false when a pivot is nought or nothing finite.
    bool factorise();
    /// With the factors, of a right side as long as size().
    Eigen::VectorXd solved(const Eigen::VectorXd &right) const;
    /// The matrix times the vector, with the values as they are now.
    Eigen::VectorXd times(const Eigen::VectorXd &vector) const;
    /// Multiplications of one factorisation and of one solution, for choosing between them.
    double factorisingWork() const { return m_factorisingWork; }
    double solvingWork() const { return m_solvingWork; }

private:
    int *columnStarts() { return m_matrix.outerIndexPtr(); }

    Eigen::SparseMatrix<double> m_matrix;
    std::vector<std::vector<int>> m_below; // of each member, the members its columns reach
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> m_factors;
    double m_factorisingWork = 0.0, m_solvingWork = 0.0;
};

} // namespace fff

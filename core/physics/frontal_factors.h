// Symmetric positive definite systems that are the sum of dense pieces, and their factors.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fff {

/// Unknowns in blocks, and pieces that each couple some of the blocks. The order of elimination and
/// the fronts are settled once; factorise() fills them with numbers.
///
/// Instead of a sparse matrix of numbers: pieces are some hundred unknowns wide and dense, so that
/// nearly all work is that of dense matrices, and ordering blocks takes no time.
/// Source  J. Liu 1992, The multifrontal method for sparse matrix solution; P. Amestoy, T. Davis,
///         I. Duff 1996 (approximate minimum degree, elements absorbed and eliminated in masses).
class FrontalFactors
{
public:
    /// sizes   of the blocks, in the order of the unknowns
    /// pieces  of each the blocks that it couples, none twice
    FrontalFactors(const std::vector<int> &sizes, const std::vector<std::vector<int>> &pieces);

    /// own     of each block, what it has besides the pieces
    /// pieces  unknowns in the order of their blocks; lower halves
    /// False where a pivot is nought, negative or not finite.
    bool factorise(const std::vector<Eigen::MatrixXd> &own,
                   const std::vector<Eigen::MatrixXd> &pieces);
    /// The same to the last bit where the pieces are what they were the last time: fronts that
    /// nothing else reaches either stay as they are.
    bool refactorise(const std::vector<Eigen::MatrixXd> &own,
                     const std::vector<Eigen::MatrixXd> &pieces);
    /// With the factors.
    Eigen::VectorXd solved(const Eigen::VectorXd &right) const;

private:
    struct Front
    {
        std::vector<int> pivots, rest;   // blocks; what is left is passed on to a later front
        std::vector<int> pieces, fronts; // what is summed up here
        std::vector<int> unknowns;       // of pivots, then of the rest
        Eigen::Index pivotSize = 0;      // unknowns
        Eigen::MatrixXd columns;         // of the pivots: lower half, then factors
        Eigen::MatrixXd passedOn;        // of the rest, its lower half
    };

    void order(const std::vector<std::vector<int>> &pieces);
    void merge();
    int sizeOf(const std::vector<int> &blocks) const;
    void settle(const std::vector<std::vector<int>> &pieces);
    bool fill(Front &front, const std::vector<Eigen::MatrixXd> &own,
              const std::vector<Eigen::MatrixXd> &pieces);
    /// Adds the lower half of what has these unknowns to the front that m_place is of.
    void add(const Eigen::MatrixXd &part, const int *unknowns, Front &front);

    std::vector<int> m_sizes, m_starts; // of blocks
    std::vector<std::vector<int>> m_pieceUnknowns;
    std::vector<Front> m_fronts;        // none before those that are summed up in it
    std::vector<int> m_place;           // of unknowns, in the front that is being filled
    std::vector<Eigen::MatrixXd> m_own; // of the factors that are there; empty: there are none
};

} // namespace fff

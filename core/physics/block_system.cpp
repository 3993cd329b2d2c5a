#include "core/physics/block_system.h"

#include <algorithm>

namespace fff {

namespace {

constexpr int kBlock = 6;

} // namespace

BlockSystem::BlockSystem(int count, const std::vector<std::pair<int, int>> &pairs)
    : m_matrix(kBlock * count, kBlock * count), m_below(count)
{
    for (const auto &[a, b] : pairs)
        m_below[std::min(a, b)].push_back(std::max(a, b));
    std::vector<int> starts{0}, rows;
    for (int i = 0; i < count; ++i) {
        std::vector<int> &below = m_below[i];
        std::sort(below.begin(), below.end());
        below.erase(std::unique(below.begin(), below.end()), below.end());
        for (int column = 0; column < kBlock; ++column) {
            for (int row = column; row < kBlock; ++row)
                rows.push_back(kBlock * i + row);
            for (int j : below) {
                for (int row = 0; row < kBlock; ++row)
                    rows.push_back(kBlock * j + row);
            }
            starts.push_back(static_cast<int>(rows.size()));
        }
    }
    m_matrix.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(starts.begin(), starts.end(), m_matrix.outerIndexPtr());
    std::copy(rows.begin(), rows.end(), m_matrix.innerIndexPtr());
    clear();
    m_factors.analyzePattern(m_matrix);
}

void BlockSystem::clear()
{
    std::fill_n(m_matrix.valuePtr(), m_matrix.nonZeros(), 0.0);
}

void BlockSystem::addDiagonal(int member, const Block6 &block)
{
    for (int column = 0; column < kBlock; ++column) {
        double *values = m_matrix.valuePtr() + columnStarts()[kBlock * member + column];
        for (int row = column; row < kBlock; ++row)
            *values++ += block(row, column);
    }
}

void BlockSystem::addCoupling(int a, int b, const Block6 &block)
{
    const int upper = std::min(a, b), lower = std::max(a, b);
    const std::vector<int> &below = m_below[upper];
    const int rank =
        static_cast<int>(std::lower_bound(below.begin(), below.end(), lower) - below.begin());
    for (int column = 0; column < kBlock; ++column) {
        double *values = m_matrix.valuePtr() + columnStarts()[kBlock * upper + column] +
                         (kBlock - column) + kBlock * rank;
        for (int row = 0; row < kBlock; ++row)
            *values++ += a == lower ? block(row, column) : block(column, row);
    }
}

Eigen::VectorXd BlockSystem::diagonal() const
{
    // It leads each column.
    Eigen::VectorXd diagonal(size());
    for (int column = 0; column < size(); ++column)
        diagonal[column] = m_matrix.valuePtr()[m_matrix.outerIndexPtr()[column]];
    return diagonal;
}

void BlockSystem::addToDiagonal(const Eigen::VectorXd &values)
{
    for (int column = 0; column < size(); ++column)
        m_matrix.valuePtr()[columnStarts()[column]] += values[column];
}

Eigen::VectorXd BlockSystem::values() const
{
    return Eigen::Map<const Eigen::VectorXd>(m_matrix.valuePtr(), m_matrix.nonZeros());
}

void BlockSystem::setValues(const Eigen::VectorXd &values)
{
    std::copy_n(values.data(), values.size(), m_matrix.valuePtr());
}

bool BlockSystem::factorise()
{
    m_factors.factorize(m_matrix);
    if (m_factors.info() != Eigen::Success)
        return false;
    if (m_factorisingWork == 0.0) {
        const auto &lower = m_factors.matrixL().nestedExpression();
        for (int column = 0; column < size(); ++column) {
            const double below = lower.outerIndexPtr()[column + 1] - lower.outerIndexPtr()[column];
            m_factorisingWork += 0.5 * below * below;
            m_solvingWork += 2.0 * below;
        }
    }
    return true;
}

Eigen::VectorXd BlockSystem::solved(const Eigen::VectorXd &right) const
{
    return m_factors.solve(right);
}

Eigen::VectorXd BlockSystem::times(const Eigen::VectorXd &vector) const
{
    return m_matrix.selfadjointView<Eigen::Lower>() * vector;
}

} // namespace fff

#include "core/physics/least_energy.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kSpring = 1e-6;     // of the structure's own stiffness: what it is held by
constexpr double kRefined = 1e-12;   // of the right side: what refinement may leave
constexpr int kRefinements = 40;     // at most
constexpr double kBoundSlack = 1e-9; // of the largest unknown or slope: what is at a bound
constexpr int kPassesAtOnce = 10;    // then one change a pass
constexpr int kPassesPerBound = 3;   // of the worst, before the first
constexpr double kNothing = 1e-300;  // keeps a scale of nothing from being divided by

using EnergyMatrix = Eigen::SparseMatrix<double>;

/// The state of the active set, and what solves with it.
class EnergySearch
{
public:
    explicit EnergySearch(const EnergyProblem &problem)
        : m_problem(problem), m_size(problem.slope.size()), m_rows(problem.constant.size()),
          m_isFixed(static_cast<std::size_t>(m_size), false)
    {
        m_result.unknowns = Eigen::VectorXd::Zero(m_size);
        m_result.multipliers = Eigen::VectorXd::Zero(m_rows);
        const Eigen::VectorXd diagonal = problem.energy.diagonal();
        m_spring = m_size > 0 ? kSpring / diagonal.mean() : 1.0;
    }

    /// False when the matrix cannot be factored.
    bool solve();
    /// Unknowns whose state is wrong, with how much, over the scale of its kind.
    std::vector<std::pair<double, int>> faults() const;
    void change(int unknown) { m_isFixed[at(unknown)] = !m_isFixed[at(unknown)]; }
    int bounds() const
    {
        return static_cast<int>(
            std::count_if(m_problem.bounds.begin(), m_problem.bounds.end(),
                          [](const EnergyBound &b) { return b.kind != EnergyBound::Kind::None; }));
    }
    LeastEnergy result(int passes, bool isSettled) &&
    {
        m_result.passes = passes;
        m_result.isSettled = isSettled;
        m_result.isAtBound.assign(m_isFixed.begin(), m_isFixed.end());
        m_result.residual = m_problem.equations * m_result.unknowns + m_problem.constant;
        return std::move(m_result);
    }

private:
    static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }
    bool isFixed(Eigen::Index i) const
    {
        const int leader = m_problem.bounds[at(i)].follows;
        return m_isFixed[at(i)] || (leader >= 0 && m_isFixed[at(leader)]);
    }
    void number();
    EnergyMatrix conditions() const;

    const EnergyProblem &m_problem;
    Eigen::Index m_size, m_rows;
    std::vector<bool> m_isFixed;
    std::vector<Eigen::Index> m_number; // among the free unknowns; −1: fixed
    Eigen::Index m_free = 0;
    double m_spring = 1.0;
    LeastEnergy m_result;
};

void EnergySearch::number()
{
    m_number.assign(at(m_size), -1);
    m_free = 0;
    for (Eigen::Index i = 0; i < m_size; ++i) {
        if (!isFixed(i))
            m_number[at(i)] = m_free++;
    }
}

/// [H A'; A 0] of the free unknowns, both halves.
EnergyMatrix EnergySearch::conditions() const
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(at(m_problem.energy.nonZeros() + 2 * m_problem.equations.nonZeros() + m_rows));
    const auto each = [](const EnergyMatrix &matrix, const auto &use) {
        for (Eigen::Index k = 0; k < matrix.outerSize(); ++k) {
            for (EnergyMatrix::InnerIterator it(matrix, k); it; ++it)
                use(it.row(), it.col(), it.value());
        }
    };
    each(m_problem.energy, [&](Eigen::Index i, Eigen::Index j, double value) {
        if (m_number[at(i)] >= 0 && m_number[at(j)] >= 0)
            entries.emplace_back(m_number[at(i)], m_number[at(j)], value);
    });
    each(m_problem.equations, [&](Eigen::Index i, Eigen::Index j, double value) {
        if (m_number[at(j)] < 0)
            return;
        entries.emplace_back(m_free + i, m_number[at(j)], value);
        entries.emplace_back(m_number[at(j)], m_free + i, value);
    });
    EnergyMatrix matrix(m_free + m_rows, m_free + m_rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

bool EnergySearch::solve()
{
    number();
    Eigen::VectorXd &x = m_result.unknowns;
    for (Eigen::Index i = 0; i < m_size; ++i) {
        if (isFixed(i))
            x[i] = m_isFixed[at(i)] ? m_problem.bounds[at(i)].value : 0.0;
        else
            x[i] = 0.0;
    }
    const EnergyMatrix matrix = conditions();
    EnergyMatrix springs(m_free + m_rows, m_free + m_rows);
    std::vector<Eigen::Triplet<double>> held;
    for (Eigen::Index i = 0; i < m_rows; ++i)
        held.emplace_back(m_free + i, m_free + i, -m_spring);
    springs.setFromTriplets(held.begin(), held.end());
    const Eigen::SimplicialLDLT<EnergyMatrix> factor(matrix + springs);
    if (factor.info() != Eigen::Success)
        return false;

    const Eigen::VectorXd slope = m_problem.slope + m_problem.energy * x;
    Eigen::VectorXd right(m_free + m_rows);
    for (Eigen::Index i = 0; i < m_size; ++i) {
        if (m_number[at(i)] >= 0)
            right[m_number[at(i)]] = -slope[i];
    }
    right.tail(m_rows) = -(m_problem.constant + m_problem.equations * x);
    // Two scales: displacements above, forces below.
    const double above = std::max(right.head(m_free).norm(), kNothing),
                 below = std::max(right.tail(m_rows).norm(), kNothing);
    Eigen::VectorXd found = Eigen::VectorXd::Zero(right.size()), rest = right;
    for (int k = 0; k < kRefinements; ++k) {
        found += factor.solve(rest);
        rest = right - matrix * found;
        const double scale = std::max(above, (m_problem.energy.diagonal().mean() * below));
        if (rest.head(m_free).norm() < kRefined * scale &&
            rest.tail(m_rows).norm() < kRefined * below)
            break;
    }
    for (Eigen::Index i = 0; i < m_size; ++i) {
        if (m_number[at(i)] >= 0)
            x[i] = found[m_number[at(i)]];
    }
    m_result.multipliers = found.tail(m_rows);
    return found.allFinite();
}

std::vector<std::pair<double, int>> EnergySearch::faults() const
{
    const Eigen::VectorXd &x = m_result.unknowns;
    const Eigen::VectorXd slope = m_problem.energy * x + m_problem.slope +
                                  m_problem.equations.transpose() * m_result.multipliers;
    const double largest = std::max(x.cwiseAbs().maxCoeff(), kNothing);
    const double steepest = largest * m_problem.energy.diagonal().mean();
    std::vector<std::pair<double, int>> found;
    for (Eigen::Index i = 0; i < m_size; ++i) {
        const EnergyBound &bound = m_problem.bounds[at(i)];
        if (bound.kind == EnergyBound::Kind::None)
            continue;
        const double sign = bound.kind == EnergyBound::Kind::AtLeast ? 1.0 : -1.0;
        const double fault =
            m_isFixed[at(i)] ? -sign * slope[i] / steepest : sign * (bound.value - x[i]) / largest;
        if (fault > kBoundSlack)
            found.emplace_back(fault, static_cast<int>(i));
    }
    return found;
}

} // namespace

LeastEnergy leastEnergy(const EnergyProblem &problem, const LongWork &work)
{
    EnergySearch search(problem);
    const int bounds = search.bounds();
    const int bland = kPassesAtOnce + kPassesPerBound * bounds, most = bland + 10 * bounds + 10;
    double share = 0.0;
    for (int pass = 1; pass <= most; ++pass) {
        if (work.isStopped() || !search.solve())
            return std::move(search).result(pass, false);
        const std::vector<std::pair<double, int>> faults = search.faults();
        if (faults.empty()) {
            work.tell(1.0);
            return std::move(search).result(pass, true);
        }
        if (pass <= kPassesAtOnce) {
            for (const auto &[fault, unknown] : faults)
                search.change(unknown);
        } else if (pass <= bland) {
            search.change(std::max_element(faults.begin(), faults.end())->second);
        } else {
            search.change(faults.front().second);
        }
        share += 0.3 * (1.0 - share);
        work.tell(share);
    }
    return std::move(search).result(most, false);
}

} // namespace fff

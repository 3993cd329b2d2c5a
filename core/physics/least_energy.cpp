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

/// [H A'; A −springs], its lower half. Which unknowns are fixed changes values only: their rows and
/// columns become those of the identity, so that the order of elimination is found once.
class Conditions
{
public:
    Conditions(const EnergyProblem &problem, double spring)
        : m_unknowns(problem.slope.size()), m_rows(problem.constant.size()), m_spring(spring)
    {
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(static_cast<std::size_t>(
            problem.energy.nonZeros() + problem.equations.nonZeros() + m_rows + m_unknowns));
        const auto each = [](const EnergyMatrix &matrix, const auto &use) {
            for (Eigen::Index k = 0; k < matrix.outerSize(); ++k)
                for (EnergyMatrix::InnerIterator it(matrix, k); it; ++it)
                    use(it.row(), it.col(), it.value());
        };
        each(problem.energy, [&](Eigen::Index i, Eigen::Index j, double value) {
            if (i >= j)
                entries.emplace_back(i, j, value);
        });
        each(problem.equations, [&](Eigen::Index i, Eigen::Index j, double value) {
            entries.emplace_back(m_unknowns + i, j, value);
        });
        for (Eigen::Index i = 0; i < m_unknowns + m_rows; ++i)
            entries.emplace_back(i, i, 0.0); // each has a diagonal
        m_matrix.resize(m_unknowns + m_rows, m_unknowns + m_rows);
        m_matrix.setFromTriplets(entries.begin(), entries.end());
        m_values.assign(m_matrix.valuePtr(), m_matrix.valuePtr() + m_matrix.nonZeros());
        m_factors.analyzePattern(m_matrix);
    }

    /// isFixed(unknown). False where it cannot be factored.
    template <class IsFixed>
    bool factorise(const IsFixed &isFixed)
    {
        std::vector<char> fixed(static_cast<std::size_t>(m_unknowns + m_rows), 0);
        for (Eigen::Index i = 0; i < m_unknowns; ++i)
            fixed[static_cast<std::size_t>(i)] = isFixed(i) ? 1 : 0;
        double *value = m_matrix.valuePtr();
        std::copy(m_values.begin(), m_values.end(), value);
        for (Eigen::Index j = 0; j < m_matrix.outerSize(); ++j)
            for (EnergyMatrix::InnerIterator it(m_matrix, j); it; ++it)
                if (fixed[static_cast<std::size_t>(it.row())] || fixed[static_cast<std::size_t>(j)])
                    it.valueRef() = it.row() == j ? 1.0 : 0.0;
        // What the factors are held by is no part of what is solved.
        EnergyMatrix held = m_matrix;
        for (Eigen::Index j = m_unknowns; j < held.outerSize(); ++j)
            held.coeffRef(j, j) -= m_spring;
        m_factors.factorize(held);
        return m_factors.info() == Eigen::Success;
    }
    Eigen::VectorXd solved(const Eigen::VectorXd &right) const { return m_factors.solve(right); }
    Eigen::VectorXd times(const Eigen::VectorXd &vector) const
    {
        return m_matrix.selfadjointView<Eigen::Lower>() * vector;
    }

private:
    Eigen::Index m_unknowns, m_rows;
    double m_spring;
    EnergyMatrix m_matrix;
    std::vector<double> m_values; // with all unknowns free
    Eigen::SimplicialLDLT<EnergyMatrix, Eigen::Lower> m_factors;
};

double springOf(const EnergyProblem &problem)
{
    return problem.slope.size() > 0 ? kSpring / problem.energy.diagonal().mean() : 1.0;
}

/// The state of the active set, and what solves with it.
class EnergySearch
{
public:
    explicit EnergySearch(const EnergyProblem &problem)
        : m_problem(problem), m_size(problem.slope.size()), m_rows(problem.constant.size()),
          m_isFixed(static_cast<std::size_t>(m_size), false),
          m_conditions(problem, springOf(problem))
    {
        m_result.unknowns = Eigen::VectorXd::Zero(m_size);
        m_result.multipliers = Eigen::VectorXd::Zero(m_rows);
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

    const EnergyProblem &m_problem;
    Eigen::Index m_size, m_rows;
    std::vector<bool> m_isFixed;
    Conditions m_conditions;
    LeastEnergy m_result;
};

bool EnergySearch::solve()
{
    Eigen::VectorXd &x = m_result.unknowns;
    for (Eigen::Index i = 0; i < m_size; ++i)
        x[i] = m_isFixed[at(i)] ? m_problem.bounds[at(i)].value : 0.0;
    if (!m_conditions.factorise([this](Eigen::Index i) { return isFixed(i); }))
        return false;
    Eigen::VectorXd right(m_size + m_rows);
    right.head(m_size) = -(m_problem.slope + m_problem.energy * x);
    for (Eigen::Index i = 0; i < m_size; ++i)
        if (isFixed(i))
            right[i] = 0.0;
    right.tail(m_rows) = -(m_problem.constant + m_problem.equations * x);
    // Two scales: displacements above, forces below.
    const double above = std::max(right.head(m_size).norm(), kNothing),
                 below = std::max(right.tail(m_rows).norm(), kNothing);
    const double scale = std::max(above, m_problem.energy.diagonal().mean() * below);
    Eigen::VectorXd found = Eigen::VectorXd::Zero(right.size()), rest = right;
    for (int k = 0; k < kRefinements; ++k) {
        found += m_conditions.solved(rest);
        rest = right - m_conditions.times(found);
        if (rest.head(m_size).norm() < kRefined * scale &&
            rest.tail(m_rows).norm() < kRefined * below)
            break;
    }
    x += found.head(m_size); // nothing where it is fixed
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

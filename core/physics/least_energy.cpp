#include "core/physics/least_energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace fff {

namespace {

constexpr double kSpring = 1e-6;     // of the structure's own stiffness: what it is held by
constexpr double kRefined = 1e-12;   // of the right side: what refinement may leave
constexpr int kRefinements = 40;     // at most
constexpr double kBoundSlack = 1e-9; // of the largest unknown or slope: what is at a bound
constexpr int kPassesAtOnce = 10;    // then one change a pass
/// Of the worst fault: what is smaller may well be gone when the others are. So half the passes do.
constexpr double kWorthAPass = 0.02;
constexpr int kPassesPerBound = 3;  // of the worst, before the first
constexpr double kNothing = 1e-300; // keeps a scale of nothing from being divided by

std::vector<std::vector<int>> blocksOf(const std::vector<EnergyPiece> &pieces)
{
    std::vector<std::vector<int>> blocks;
    for (const EnergyPiece &piece : pieces)
        blocks.push_back(piece.blocks);
    return blocks;
}

double meanDiagonal(const EnergyProblem &problem)
{
    double sum = 0.0;
    for (const Eigen::MatrixXd &own : problem.own)
        sum += own.trace();
    for (const EnergyPiece &piece : problem.pieces)
        sum += piece.energy.trace();
    return problem.slope.size() > 0 ? sum / static_cast<double>(problem.slope.size()) : 0.0;
}

} // namespace

LeastEnergySearch::LeastEnergySearch(EnergyProblem problem)
    : m_problem(std::move(problem)), m_scale(meanDiagonal(m_problem)),
      m_spring(m_scale > 0.0 ? kSpring / m_scale : 1.0), m_starts(m_problem.sizes.size()),
      m_factors(m_problem.sizes, blocksOf(m_problem.pieces))
{
    std::exclusive_scan(m_problem.sizes.begin(), m_problem.sizes.end(), m_starts.begin(), 0);
    for (const EnergyPiece &piece : m_problem.pieces) {
        m_unknowns.emplace_back();
        for (const int block : piece.blocks)
            for (int i = 0; i < m_problem.sizes[static_cast<std::size_t>(block)]; ++i)
                m_unknowns.back().push_back(m_starts[static_cast<std::size_t>(block)] + i);
        m_held.push_back(piece.energy);
        m_held.back().selfadjointView<Eigen::Lower>().rankUpdate(piece.equations.transpose(),
                                                                 1.0 / m_spring);
    }
}

void LeastEnergySearch::setRows(const std::vector<int> &zeros)
{
    m_rows.clear();
    const auto hold = [this](int block, int unknown, int bound) {
        Row row{block, Eigen::VectorXd::Zero(m_problem.sizes[at(block)]), 0.0, bound};
        row.direction[unknown] = 1.0;
        m_rows.push_back(std::move(row));
    };
    std::vector<char> isLoose(m_problem.sizes.size(), 0);
    for (std::size_t k = 0; k < m_problem.bounds.size(); ++k) {
        const EnergyBound &bound = m_problem.bounds[k];
        if (!m_isAtBound[k])
            continue;
        if (!bound.isLoose) {
            m_rows.push_back({bound.block, bound.direction, bound.value, static_cast<int>(k)});
            continue;
        }
        isLoose[at(bound.block)] = 1;
        for (int i = 0; i < m_problem.sizes[at(bound.block)]; ++i)
            hold(bound.block, i, bound.direction[i] != 0.0 ? static_cast<int>(k) : -1);
    }
    for (const int unknown : zeros) {
        const auto block = std::upper_bound(m_starts.begin(), m_starts.end(), unknown) - 1;
        const int index = static_cast<int>(block - m_starts.begin());
        if (!isLoose[at(index)])
            hold(index, unknown - *block, -1);
    }
}

Eigen::VectorXd LeastEnergySearch::gathered(std::size_t piece, const Eigen::VectorXd &x) const
{
    const std::vector<int> &unknowns = m_unknowns[piece];
    Eigen::VectorXd of(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        of[static_cast<Eigen::Index>(i)] = x[unknowns[i]];
    return of;
}

Eigen::VectorBlock<Eigen::VectorXd> LeastEnergySearch::segment(Eigen::VectorXd &x, int block) const
{
    return x.segment(m_starts[at(block)], m_problem.sizes[at(block)]);
}

LeastEnergySearch::Rest LeastEnergySearch::rest()
{
    Rest rest{-m_problem.slope, Eigen::VectorXd::Zero(m_x.size()), {}, {}, 0.0};
    for (std::size_t b = 0; b < m_problem.own.size(); ++b) {
        const int block = static_cast<int>(b);
        segment(rest.slope, block) -= m_problem.own[b] * segment(m_x, block);
    }
    double missed = 0.0;
    for (std::size_t i = 0; i < m_problem.pieces.size(); ++i) {
        const EnergyPiece &piece = m_problem.pieces[i];
        const Eigen::VectorXd x = gathered(i, m_x);
        const Eigen::VectorXd left = -piece.constant - piece.equations * x;
        const Eigen::VectorXd sprung = piece.equations.transpose() * left / m_spring;
        Eigen::VectorXd slope = -(piece.equations.transpose() * m_multipliers[i]);
        slope.noalias() -= piece.energy.selfadjointView<Eigen::Lower>() * x;
        for (std::size_t j = 0; j < m_unknowns[i].size(); ++j) {
            rest.slope[m_unknowns[i][j]] += slope[static_cast<Eigen::Index>(j)];
            rest.sprung[m_unknowns[i][j]] += sprung[static_cast<Eigen::Index>(j)];
        }
        missed += left.squaredNorm();
        rest.pieces.push_back(left);
    }
    for (const Row &row : m_rows) {
        const double left = row.value - row.direction.dot(segment(m_x, row.block));
        segment(rest.slope, row.block) -= row.multiplier * row.direction;
        segment(rest.sprung, row.block) += left / m_spring * row.direction;
        missed += left * left;
        rest.rows.push_back(left);
    }
    rest.missed = std::sqrt(missed);
    return rest;
}

void LeastEnergySearch::refine(const Rest &rest)
{
    Eigen::VectorXd step = m_factors.solved(rest.slope + rest.sprung);
    // Of what the step leaves, not of all: springs are so stiff that its rounding would count.
    for (std::size_t i = 0; i < m_problem.pieces.size(); ++i)
        m_multipliers[i] +=
            (m_problem.pieces[i].equations * gathered(i, step) - rest.pieces[i]) / m_spring;
    for (std::size_t r = 0; r < m_rows.size(); ++r)
        m_rows[r].multiplier +=
            (m_rows[r].direction.dot(segment(step, m_rows[r].block)) - rest.rows[r]) / m_spring;
    m_x += step;
}

bool LeastEnergySearch::solve()
{
    std::vector<Eigen::MatrixXd> own = m_problem.own;
    double squares = 0.0;
    for (const Row &row : m_rows) {
        own[at(row.block)] += row.direction * row.direction.transpose() / m_spring;
        squares += row.value * row.value;
    }
    m_x.setZero(m_problem.slope.size());
    m_multipliers.clear();
    for (const EnergyPiece &piece : m_problem.pieces) {
        m_multipliers.push_back(Eigen::VectorXd::Zero(piece.constant.size()));
        squares += piece.constant.squaredNorm();
    }
    if (!m_factors.refactorise(own, m_held))
        return false;
    // Two scales: displacements and forces.
    const double forces = std::max(std::sqrt(squares), kNothing);
    const double moves = std::max(m_problem.slope.norm(), m_scale * forces);
    for (int k = 0; k < kRefinements; ++k) {
        const Rest left = rest();
        if (left.slope.norm() < kRefined * moves && left.missed < kRefined * forces)
            break;
        refine(left);
    }
    return m_x.allFinite();
}

void LeastEnergySearch::finish()
{
    refine(rest());               // once more: how well that is told is what answers differ in
    for (const Row &row : m_rows) // exactly: nought is nought
        segment(m_x, row.block) -= (row.direction.dot(segment(m_x, row.block)) - row.value) /
                                   row.direction.squaredNorm() * row.direction;
}

std::vector<std::pair<double, int>> LeastEnergySearch::faults() const
{
    const double largest = std::max({m_x.cwiseAbs().maxCoeff(), m_problem.leastForce, kNothing});
    const double steepest = largest * m_scale;
    std::vector<std::pair<double, int>> found;
    const auto look = [&](double fault, std::size_t bound) {
        if (fault > kBoundSlack)
            found.emplace_back(fault, static_cast<int>(bound));
    };
    const auto sign = [](const EnergyBound &bound) {
        return bound.kind == EnergyBound::Kind::AtLeast ? 1.0 : -1.0;
    };
    for (const Row &row : m_rows) {
        if (row.bound >= 0)
            look(sign(m_problem.bounds[at(row.bound)]) * row.multiplier / steepest, at(row.bound));
    }
    for (std::size_t k = 0; k < m_problem.bounds.size(); ++k) {
        const EnergyBound &bound = m_problem.bounds[k];
        if (m_isAtBound[k])
            continue;
        const double sum = bound.direction.dot(
            m_x.segment(m_starts[at(bound.block)], m_problem.sizes[at(bound.block)]));
        look(sign(bound) * (bound.value - sum) / largest, k);
    }
    std::sort(found.begin(), found.end(),
              [](const auto &a, const auto &b) { return a.second < b.second; });
    return found;
}

LeastEnergy LeastEnergySearch::least(const std::vector<int> &zeros, const LongWork &work)
{
    const int bounds = static_cast<int>(m_problem.bounds.size());
    if (!std::exchange(m_isSettled, false))
        m_isAtBound.assign(m_problem.bounds.size(), false);
    const int bland = kPassesAtOnce + kPassesPerBound * bounds, most = bland + 10 * bounds + 10;
    const auto result = [this](int passes, bool isSettled) {
        return LeastEnergy{m_x, m_isAtBound, passes, isSettled};
    };
    const auto change = [this](int bound) { m_isAtBound[at(bound)] = !m_isAtBound[at(bound)]; };
    double share = 0.0;
    for (int pass = 1; pass <= most; ++pass) {
        setRows(zeros);
        if (work.isStopped() || !solve())
            return result(pass, false);
        const std::vector<std::pair<double, int>> wrong = faults();
        if (wrong.empty()) {
            finish();
            m_isSettled = true;
            work.tell(1.0);
            return result(pass, true);
        }
        const auto worst = *std::max_element(wrong.begin(), wrong.end());
        if (pass <= kPassesAtOnce) {
            for (const auto &[fault, bound] : wrong)
                if (fault >= kWorthAPass * worst.first)
                    change(bound);
        } else {
            change(pass <= bland ? worst.second : wrong.front().second);
        }
        share += 0.3 * (1.0 - share);
        work.tell(share);
    }
    return result(most, false);
}

} // namespace fff

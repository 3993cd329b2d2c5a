#include "core/physics/frontal_factors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace fff {

namespace {

/// A front with fewer pivots than this is merged with the one that follows, as long as no more than
/// that share of what then is stored of their pivots is nought: dense matrices want some width.
constexpr int kNarrow = 32;
constexpr double kMostNoughts = 0.2;

/// Blocks and what couples them while they are eliminated one after the other: pieces first, then
/// also what eliminated blocks leave behind.
class Elimination
{
public:
    Elimination(const std::vector<int> &sizes, const std::vector<std::vector<int>> &pieces)
        : m_sizes(sizes), m_couplings(sizes.size()), m_degrees(sizes.size(), 0),
          m_isGone(sizes.size(), 0)
    {
        for (const std::vector<int> &piece : pieces)
            addElement(piece);
        for (std::size_t block = 0; block < sizes.size(); ++block)
            for (const int element : m_couplings[block])
                m_degrees[block] += m_elements[at(element)].weight;
    }

    struct Step
    {
        std::vector<int> pivots, rest; // blocks
        std::vector<int> absorbed;     // elements: pieces, then steps, in the order of both
    };
    /// The next one; without pivots when all blocks are gone.
    Step next()
    {
        Step step;
        const int pivot = least();
        if (pivot < 0)
            return step;
        step.pivots.push_back(pivot);
        m_isGone[at(pivot)] = 1;
        const std::vector<int> reached = absorb(pivot, step);
        measure(reached, step);
        leave(reached, step);
        return step;
    }

private:
    struct Element
    {
        std::vector<int> blocks; // none of them gone
        int weight = 0;          // unknowns of its blocks
        int outside = 0;         // of these, those that the step at hand does not reach
        bool isAlive = true;
    };

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    void addElement(const std::vector<int> &blocks)
    {
        Element element{blocks};
        for (const int block : blocks) {
            element.weight += m_sizes[at(block)];
            m_couplings[at(block)].push_back(static_cast<int>(m_elements.size()));
        }
        element.outside = element.weight;
        m_elements.push_back(std::move(element));
    }
    int least() const
    {
        int found = -1, degree = std::numeric_limits<int>::max();
        for (std::size_t block = 0; block < m_sizes.size(); ++block) {
            if (!m_isGone[block] && m_degrees[block] < degree) {
                found = static_cast<int>(block);
                degree = m_degrees[block];
            }
        }
        return found;
    }
    /// What couples the pivot goes into the step. Returns the other blocks.
    std::vector<int> absorb(int pivot, Step &step)
    {
        std::vector<int> reached;
        for (const int element : m_couplings[at(pivot)]) {
            Element &absorbed = m_elements[at(element)];
            step.absorbed.push_back(element);
            absorbed.isAlive = false;
            for (const int block : absorbed.blocks)
                if (!m_isGone[at(block)])
                    reached.push_back(block);
        }
        std::sort(reached.begin(), reached.end());
        reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
        return reached;
    }
    /// Of the elements that stay how much is outside; what is not at all goes into the step too.
    void measure(const std::vector<int> &reached, Step &step)
    {
        for (const int block : reached) {
            std::erase_if(m_couplings[at(block)],
                          [this](int element) { return !m_elements[at(element)].isAlive; });
            for (const int element : m_couplings[at(block)])
                m_elements[at(element)].outside -= m_sizes[at(block)];
        }
        for (const int block : reached) {
            std::erase_if(m_couplings[at(block)], [&](int element) {
                Element &within = m_elements[at(element)];
                if (within.outside > 0)
                    return false;
                if (within.isAlive)
                    step.absorbed.push_back(element);
                within.isAlive = false;
                return true;
            });
        }
    }
    /// Blocks that nothing else couples are eliminated with the pivot; the others are coupled.
    void leave(const std::vector<int> &reached, Step &step)
    {
        int weight = 0;
        for (const int block : reached) {
            const bool isAlone = m_couplings[at(block)].empty();
            (isAlone ? step.pivots : step.rest).push_back(block);
            m_isGone[at(block)] = isAlone ? 1 : 0;
            weight += isAlone ? 0 : m_sizes[at(block)];
        }
        for (const int block : step.rest) {
            m_degrees[at(block)] = weight - m_sizes[at(block)];
            for (const int element : m_couplings[at(block)])
                m_degrees[at(block)] += m_elements[at(element)].outside;
        }
        for (const int block : step.rest)
            for (const int element : m_couplings[at(block)])
                m_elements[at(element)].outside = m_elements[at(element)].weight;
        addElement(step.rest);
    }

    const std::vector<int> &m_sizes;
    std::vector<Element> m_elements;
    std::vector<std::vector<int>> m_couplings; // of blocks, the elements
    std::vector<int> m_degrees;                // bounds from above, unknowns
    std::vector<char> m_isGone;
};

} // namespace

FrontalFactors::FrontalFactors(const std::vector<int> &sizes,
                               const std::vector<std::vector<int>> &pieces)
    : m_sizes(sizes), m_starts(sizes.size())
{
    std::exclusive_scan(sizes.begin(), sizes.end(), m_starts.begin(), 0);
    m_place.resize(sizes.empty() ? 0 : static_cast<std::size_t>(m_starts.back() + sizes.back()));
    order(pieces);
    merge();
    settle(pieces);
}

void FrontalFactors::order(const std::vector<std::vector<int>> &pieces)
{
    Elimination elimination(m_sizes, pieces);
    const int count = static_cast<int>(pieces.size());
    while (true) {
        Elimination::Step step = elimination.next();
        if (step.pivots.empty())
            return;
        Front front;
        front.pivots = std::move(step.pivots);
        front.rest = std::move(step.rest);
        for (const int element : step.absorbed) {
            if (element < count)
                front.pieces.push_back(element);
            else
                front.fronts.push_back(element - count);
        }
        m_fronts.push_back(std::move(front));
    }
}

int FrontalFactors::sizeOf(const std::vector<int> &blocks) const
{
    return std::accumulate(blocks.begin(), blocks.end(), 0, [this](int sum, int block) {
        return sum + m_sizes[static_cast<std::size_t>(block)];
    });
}

void FrontalFactors::merge()
{
    const std::size_t count = m_fronts.size();
    std::vector<std::size_t> later(count, count);
    for (std::size_t i = 0; i < count; ++i)
        for (const int earlier : m_fronts[i].fronts)
            later[static_cast<std::size_t>(earlier)] = i;
    std::vector<double> noughts(count, 0.0);
    std::vector<char> isMerged(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        if (later[i] == count)
            continue;
        Front &front = m_fronts[i], &next = m_fronts[later[i]];
        const double pivots = sizeOf(front.pivots), nextPivots = sizeOf(next.pivots);
        const double nextSize = nextPivots + sizeOf(next.rest);
        const double more =
            noughts[i] + noughts[later[i]] + pivots * (nextSize - sizeOf(front.rest));
        if (pivots >= kNarrow || more > kMostNoughts * (pivots + nextPivots) * (pivots + nextSize))
            continue;
        noughts[later[i]] = more;
        isMerged[i] = 1;
        next.pivots.insert(next.pivots.begin(), front.pivots.begin(), front.pivots.end());
        next.pieces.insert(next.pieces.end(), front.pieces.begin(), front.pieces.end());
        std::erase(next.fronts, static_cast<int>(i));
        next.fronts.insert(next.fronts.end(), front.fronts.begin(), front.fronts.end());
        for (const int earlier : front.fronts)
            later[static_cast<std::size_t>(earlier)] = later[i];
    }
    std::vector<int> places(count);
    std::vector<Front> kept;
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = static_cast<int>(kept.size());
        if (isMerged[i])
            continue;
        for (int &earlier : m_fronts[i].fronts)
            earlier = places[static_cast<std::size_t>(earlier)];
        kept.push_back(std::move(m_fronts[i]));
    }
    m_fronts = std::move(kept);
}

void FrontalFactors::settle(const std::vector<std::vector<int>> &pieces)
{
    std::vector<int> turn(m_sizes.size());
    int next = 0;
    for (const Front &front : m_fronts)
        for (const int block : front.pivots)
            turn[static_cast<std::size_t>(block)] = next++;
    const auto addUnknowns = [this](const std::vector<int> &blocks, std::vector<int> &unknowns) {
        for (const int block : blocks)
            for (int i = 0; i < m_sizes[static_cast<std::size_t>(block)]; ++i)
                unknowns.push_back(m_starts[static_cast<std::size_t>(block)] + i);
    };
    for (const std::vector<int> &piece : pieces) {
        m_pieceUnknowns.emplace_back();
        addUnknowns(piece, m_pieceUnknowns.back());
    }
    for (Front &front : m_fronts) {
        // In the order in which they go, so that lower halves stay lower halves.
        std::sort(front.rest.begin(), front.rest.end(), [&turn](int a, int b) {
            return turn[static_cast<std::size_t>(a)] < turn[static_cast<std::size_t>(b)];
        });
        addUnknowns(front.pivots, front.unknowns);
        front.pivotSize = static_cast<Eigen::Index>(front.unknowns.size());
        addUnknowns(front.rest, front.unknowns);
    }
}

void FrontalFactors::add(const Eigen::MatrixXd &part, const int *unknowns, Front &front)
{
    const Eigen::Index pivots = front.pivotSize;
    for (Eigen::Index column = 0; column < part.cols(); ++column) {
        const Eigen::Index to = m_place[static_cast<std::size_t>(unknowns[column])];
        for (Eigen::Index row = column; row < part.rows(); ++row) {
            const Eigen::Index place = m_place[static_cast<std::size_t>(unknowns[row])];
            const Eigen::Index below = std::max(place, to), beside = std::min(place, to);
            double &sum = beside < pivots ? front.columns(below, beside)
                                          : front.passedOn(below - pivots, beside - pivots);
            sum += part(row, column);
        }
    }
}

bool FrontalFactors::factorise(const std::vector<Eigen::MatrixXd> &own,
                               const std::vector<Eigen::MatrixXd> &pieces)
{
    m_own.clear();
    return refactorise(own, pieces);
}

bool FrontalFactors::refactorise(const std::vector<Eigen::MatrixXd> &own,
                                 const std::vector<Eigen::MatrixXd> &pieces)
{
    const std::vector<Eigen::MatrixXd> before = std::exchange(m_own, {});
    const auto isNew = [&](int block) {
        const auto i = static_cast<std::size_t>(block);
        return before.empty() || before[i] != own[i];
    };
    std::vector<char> isFilled(m_fronts.size(), 0);
    for (std::size_t i = 0; i < m_fronts.size(); ++i) {
        Front &front = m_fronts[i];
        const bool isReached =
            std::any_of(front.fronts.begin(), front.fronts.end(),
                        [&](int earlier) { return isFilled[static_cast<std::size_t>(earlier)]; });
        if (!isReached && std::none_of(front.pivots.begin(), front.pivots.end(), isNew))
            continue;
        isFilled[i] = 1;
        if (!fill(front, own, pieces))
            return false;
    }
    m_own = own;
    return true;
}

bool FrontalFactors::fill(Front &front, const std::vector<Eigen::MatrixXd> &own,
                          const std::vector<Eigen::MatrixXd> &pieces)
{
    const auto size = static_cast<Eigen::Index>(front.unknowns.size());
    const Eigen::Index left = size - front.pivotSize;
    for (std::size_t i = 0; i < front.unknowns.size(); ++i)
        m_place[static_cast<std::size_t>(front.unknowns[i])] = static_cast<int>(i);
    front.columns.setZero(size, front.pivotSize);
    front.passedOn.setZero(left, left);
    Eigen::Index start = 0;
    for (const int block : front.pivots) {
        const Eigen::MatrixXd &matrix = own[static_cast<std::size_t>(block)];
        front.columns.block(start, start, matrix.rows(), matrix.cols()) += matrix;
        start += matrix.rows();
    }
    for (const int piece : front.pieces)
        add(pieces[static_cast<std::size_t>(piece)],
            m_pieceUnknowns[static_cast<std::size_t>(piece)].data(), front);
    for (const int index : front.fronts) {
        const Front &earlier = m_fronts[static_cast<std::size_t>(index)];
        add(earlier.passedOn, earlier.unknowns.data() + earlier.pivotSize, front);
    }
    Eigen::Ref<Eigen::MatrixXd> top = front.columns.topRows(front.pivotSize);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(top);
    if (factors.info() != Eigen::Success || !top.diagonal().allFinite())
        return false;
    if (left == 0)
        return true;
    auto below = front.columns.bottomRows(left);
    top.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    front.passedOn.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
    return true;
}

Eigen::VectorXd FrontalFactors::solved(const Eigen::VectorXd &right) const
{
    Eigen::VectorXd x = right;
    Eigen::VectorXd local;
    const auto gather = [&](const Front &front) {
        local.resize(front.columns.rows());
        for (Eigen::Index i = 0; i < local.size(); ++i)
            local[i] = x[front.unknowns[static_cast<std::size_t>(i)]];
    };
    const auto scatter = [&](const Front &front, Eigen::Index count) {
        for (Eigen::Index i = 0; i < count; ++i)
            x[front.unknowns[static_cast<std::size_t>(i)]] = local[i];
    };
    for (const Front &front : m_fronts) {
        gather(front);
        const Eigen::Index left = local.size() - front.pivotSize;
        auto pivots = local.head(front.pivotSize);
        front.columns.topRows(front.pivotSize).triangularView<Eigen::Lower>().solveInPlace(pivots);
        local.tail(left).noalias() -= front.columns.bottomRows(left) * pivots;
        scatter(front, local.size());
    }
    for (auto front = m_fronts.rbegin(); front != m_fronts.rend(); ++front) {
        gather(*front);
        const Eigen::Index left = local.size() - front->pivotSize;
        auto pivots = local.head(front->pivotSize);
        pivots.noalias() -= front->columns.bottomRows(left).transpose() * local.tail(left);
        front->columns.topRows(front->pivotSize)
            .triangularView<Eigen::Lower>()
            .transpose()
            .solveInPlace(pivots);
        scatter(*front, front->pivotSize);
    }
    return x;
}

} // namespace fff

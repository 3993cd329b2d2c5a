#include "core/nesting/separation.h"

#include "core/geometry/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff::nest {

namespace {

// How many places are tried, and of these how many are made better.
constexpr int kAnywhere = 40;
constexpr int kNearby = 20;
constexpr std::size_t kKept = 3;
// Steps of the descent, as parts of the lesser side.
constexpr double kFirstStep = 0.25, kCoarseStep = 0.02, kFineStep = 0.001;
constexpr double kLonger = 1.1, kShorter = 0.5;
// Turns go along with steps: at the first step by this much, radians.
constexpr double kFirstTurn = 0.35;
// Two places nearer than this part of the lesser side are one.
constexpr double kSamePlace = 0.01;
// Of a pair's diameter: depth below which overlaps fade.
constexpr double kSoftShare = 0.01;
// Weights of pairs: how they grow while pairs overlap, and fall afterwards.
constexpr float kLeastRise = 1.2f, kMostRise = 2.0f, kDecay = 0.95f;
// An attempt has made something better if it leaves no more than this of the loss.
constexpr double kBetter = 0.98;

} // namespace

Separation::Separation(Board &board, std::uint64_t seed)
    : m_board(board), m_random(seed), m_size(board.size()), m_losses(m_size * m_size, 0.0f),
      m_weights(m_size * m_size, 1.0f), m_sums(m_size, 0.0)
{
}

double Separation::pairLoss(const Shape &a, const Posed &posedA, std::size_t b, const Vec2 &by,
                            Meter &meter) const
{
    const Shape &other = m_board.shape(b);
    const Posed &posedB = m_board.posed(b);
    const double soft = kSoftShare * std::max(a.diameter, other.diameter);
    const Depth deep = depth(posedA.poles, posedB.poles, by, static_cast<float>(soft));
    meter.used += static_cast<Steps>(posedA.poles.count * posedB.poles.padded / 4);
    if (!(deep.deepest > 0.0f) && !collide(posedA, posedB, by, meter.used))
        return 0.0;
    const double shared = std::numbers::pi * std::max(0.0f, deep.sum) + soft * soft;
    return std::sqrt(shared) * a.weight * other.weight;
}

double Separation::lossAt(std::size_t item, const Posed &posed, const Vec2 &at, double bound,
                          Meter &meter) const
{
    double loss = 0.0;
    const Shape &shape = m_board.shape(item);
    const float *weights = &m_weights[item * m_size];
    meter.used += 8;
    m_board.anyNear({posed.box.min + at, posed.box.max + at}, [&](std::size_t other) {
        if (other != item)
            loss += static_cast<double>(weights[other]) *
                    pairLoss(shape, posed, other, at - m_board.at(other), meter);
        return loss >= bound;
    });
    return loss;
}

/// Losses with all others.
void Separation::lookAt(std::size_t item, Meter &meter)
{
    for (std::size_t other = 0; other < m_size; ++other) {
        if (lossOf(item, other) == 0.0f)
            continue;
        m_sums[other] -= static_cast<double>(lossOf(item, other));
        lossOf(item, other) = lossOf(other, item) = 0.0f;
        // Sums of losses that are gone are rounding.
        const float *row = &m_losses[other * m_size];
        if (std::all_of(row, row + m_size, [](float loss) { return loss == 0.0f; }))
            m_sums[other] = 0.0;
    }
    m_sums[item] = 0.0;
    const Shape &shape = m_board.shape(item);
    const Posed &posed = m_board.posed(item);
    m_board.anyNear(m_board.box(item), [&](std::size_t other) {
        if (other == item)
            return false;
        const double loss =
            pairLoss(shape, posed, other, m_board.at(item) - m_board.at(other), meter);
        lossOf(item, other) = lossOf(other, item) = static_cast<float>(loss);
        m_sums[item] += static_cast<double>(static_cast<float>(loss));
        m_sums[other] += static_cast<double>(static_cast<float>(loss));
        return false;
    });
}

void Separation::look(Meter &meter)
{
    std::fill(m_losses.begin(), m_losses.end(), 0.0f);
    std::fill(m_sums.begin(), m_sums.end(), 0.0);
    for (std::size_t item = 0; item < m_board.count(); ++item)
        lookAt(item, meter);
}

double Separation::loss() const
{
    double loss = 0.0;
    for (std::size_t i = 0; i < m_size; ++i)
        for (std::size_t j = i + 1; j < m_size; ++j)
            loss += static_cast<double>(m_losses[i * m_size + j]);
    return loss;
}

std::vector<Pose> Separation::poses() const
{
    std::vector<Pose> poses;
    poses.reserve(m_board.count());
    for (std::size_t item = 0; item < m_board.count(); ++item)
        poses.push_back(m_board.pose(item));
    return poses;
}

void Separation::setPoses(const std::vector<Pose> &poses)
{
    for (std::size_t item = 0; item < poses.size(); ++item)
        m_board.place(item, poses[item]);
}

const Posed &Separation::posedAt(std::size_t item, const Pose &at)
{
    if (at.turn != Pose::kFree)
        return m_board.shape(item).turns[static_cast<std::size_t>(at.turn)];
    if (at.direction == m_board.posed(item).turn)
        return m_board.posed(item);
    if (m_turned.edges.empty() || m_turned.turn != at.direction)
        pose(m_board.shape(item).outline, m_board.shape(item).poles, at.direction, m_turned);
    return m_turned;
}

/// Moved onto its sheet; none where it does not fit there or is not below the bound.
std::optional<Separation::Candidate> Separation::evaluated(std::size_t item, Pose at, double bound,
                                                           Meter &meter)
{
    const Posed &posed = posedAt(item, at);
    const double middle = 0.5 * (posed.box.min.x() + posed.box.max.x()) + at.at.x();
    const std::optional<Vec2> inside = m_board.within(posed, at.at, m_board.sheetAt(middle));
    if (!inside)
        return std::nullopt;
    at.at = *inside;
    const double loss = lossAt(item, posed, at.at, bound, meter);
    return loss < bound ? std::optional(Candidate{at, loss}) : std::nullopt;
}

Pose Separation::anywhere(std::size_t item)
{
    const Shape &shape = m_board.shape(item);
    Pose at;
    at.turn = static_cast<int>(m_random.below(shape.turns.size()));
    if (shape.turnsFreely && m_random.share() < 0.5) {
        const double angle = m_random.between(-std::numbers::pi, std::numbers::pi);
        at.turn = Pose::kFree;
        at.direction = {std::cos(angle), std::sin(angle)};
    }
    const Posed &posed = posedAt(item, at);
    const std::vector<Box2> &sheets = m_board.sheets();
    const Box2 &sheet = sheets[sheets.size() == 1 ? 0 : m_random.below(sheets.size())];
    const Vec2 low = sheet.min - posed.box.min, high = sheet.max - posed.box.max;
    at.at = {m_random.between(low.x(), std::max(low.x(), high.x())),
             m_random.between(low.y(), std::max(low.y(), high.y()))};
    return at;
}

Pose Separation::nearby(std::size_t item)
{
    const Shape &shape = m_board.shape(item);
    const Vec2 middle = m_board.box(item).center(), half = 0.5 * m_board.box(item).size();
    Pose at = m_board.pose(item);
    if (shape.turnsFreely) {
        const double angle = kFirstTurn * m_random.bell();
        at.direction = turned(m_board.posed(item).turn, Vec2(std::cos(angle), std::sin(angle)));
        at.direction.normalize();
        at.turn = Pose::kFree;
    } else {
        at.turn = static_cast<int>(m_random.below(shape.turns.size()));
    }
    const Vec2 away(half.x() * m_random.between(-1.0, 1.0), half.y() * m_random.between(-1.0, 1.0));
    at.at = middle + away - posedAt(item, at).box.center();
    return at;
}

/// Keeps the best that are not the same place.
void Separation::consider(std::size_t item, const Candidate &candidate)
{
    const double near = kSamePlace * m_board.shape(item).least;
    for (Candidate &other : m_best) {
        const bool isSame = other.pose.turn == candidate.pose.turn &&
                            (other.pose.at - candidate.pose.at).cwiseAbs().maxCoeff() < near;
        if (!isSame)
            continue;
        if (candidate.loss < other.loss)
            other = candidate;
        return;
    }
    m_best.push_back(candidate);
    std::sort(m_best.begin(), m_best.end(),
              [](const Candidate &a, const Candidate &b) { return a.loss < b.loss; });
    if (m_best.size() > kKept)
        m_best.pop_back();
}

void Separation::sample(std::size_t item, Meter &meter)
{
    m_best.clear();
    const auto bound = [this] {
        return m_best.size() < kKept ? std::numeric_limits<double>::infinity() : m_best.back().loss;
    };
    if (const auto here = evaluated(item, m_board.pose(item), bound(), meter))
        consider(item, *here);
    for (int i = 0; i < kNearby; ++i)
        if (const auto candidate = evaluated(item, nearby(item), bound(), meter))
            consider(item, *candidate);
    for (int i = 0; i < kAnywhere; ++i)
        if (const auto candidate = evaluated(item, anywhere(item), bound(), meter))
            consider(item, *candidate);
}

/// Along an axis, a diagonal or by a turn, both ways, the better one; shorter steps where neither
/// is.
void Separation::descend(std::size_t item, Candidate &candidate, double step, double least,
                         Meter &meter)
{
    const Shape &shape = m_board.shape(item);
    const double turnOfStep = kFirstTurn / (kFirstStep * shape.least);
    const int ways = shape.turnsFreely ? 5 : 4;
    while (step > least && candidate.loss > 0.0 && !meter.isOver()) {
        static const std::array<Vec2, 4> kWays{Vec2(1, 0), Vec2(0, 1),
                                               Vec2(std::sqrt(0.5), std::sqrt(0.5)),
                                               Vec2(std::sqrt(0.5), -std::sqrt(0.5))};
        const auto way = m_random.below(static_cast<std::size_t>(ways));
        bool isBetter = false;
        const Candidate from = candidate;
        for (const double sign : {1.0, -1.0}) {
            Pose next = from.pose;
            if (way < kWays.size()) {
                next.at += sign * step * kWays[way];
            } else {
                const double angle = sign * step * turnOfStep;
                const Posed &posed = posedAt(item, from.pose);
                const Vec2 middle = posed.box.center() + from.pose.at;
                next.direction =
                    turned(posed.turn, Vec2(std::cos(angle), std::sin(angle))).normalized();
                next.turn = Pose::kFree;
                next.at = middle - posedAt(item, next).box.center();
            }
            if (const auto better = evaluated(item, next, candidate.loss, meter)) {
                candidate = *better;
                isBetter = true;
            }
        }
        step *= isBetter ? kLonger : kShorter;
    }
}

void Separation::move(std::size_t item, Meter &meter)
{
    const double least = m_board.shape(item).least;
    sample(item, meter);
    if (m_best.empty())
        return; // no sheet is large enough for it any more
    for (Candidate &candidate : m_best) {
        descend(item, candidate, kFirstStep * least, kCoarseStep * least, meter);
        if (candidate.loss == 0.0)
            break;
    }
    const auto isBetter = [](const Candidate &a, const Candidate &b) { return a.loss < b.loss; };
    Candidate best = *std::min_element(m_best.begin(), m_best.end(), isBetter);
    descend(item, best, kCoarseStep * least, kFineStep * least, meter);
    m_board.place(item, best.pose);
    lookAt(item, meter);
}

void Separation::moveAll(Meter &meter)
{
    std::vector<std::size_t> items;
    for (std::size_t item = 0; item < m_board.count(); ++item)
        if (overlaps(item))
            items.push_back(item);
    m_random.shuffle(items);
    for (const std::size_t item : items)
        if (overlaps(item) && !meter.isOver())
            move(item, meter);
}

void Separation::raiseWeights()
{
    const float most = *std::max_element(m_losses.begin(), m_losses.end());
    for (std::size_t i = 0; i < m_losses.size(); ++i) {
        if (m_losses[i] > 0.0f)
            m_weights[i] *= kLeastRise + (kMostRise - kLeastRise) * m_losses[i] / most;
        else
            m_weights[i] = std::max(1.0f, kDecay * m_weights[i]);
    }
}

bool Separation::run(const Patience &patience, Meter &meter)
{
    std::fill(m_weights.begin(), m_weights.end(), 1.0f);
    look(meter);
    std::vector<Pose> best = poses();
    double least = loss();
    for (int strikes = 0; strikes < patience.strikes && least > 0.0;) {
        const double before = least;
        for (int idle = 0; idle < patience.iterations && !meter.isOver();) {
            moveAll(meter);
            const double now = loss();
            if (now < least) {
                idle = now < kBetter * least ? 0 : idle + 1;
                least = now;
                best = poses();
                if (now == 0.0)
                    return true;
            } else {
                ++idle;
            }
            raiseWeights();
        }
        strikes = least < kBetter * before ? 0 : strikes + 1;
        setPoses(best);
        look(meter);
        if (meter.isOver())
            break;
    }
    return least == 0.0;
}

} // namespace fff::nest

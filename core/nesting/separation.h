// Takes shapes that overlap apart. Internal to nesting.
#pragma once

#include "core/nesting/board.h"
#include "core/nesting/meter.h"
#include "core/nesting/random.h"

namespace fff::nest {

/// When to give up.
struct Patience
{
    int strikes = 3;     // attempts in a row that make nothing better
    int iterations = 60; // of one attempt, in a row, that make nothing better
};

/// Guided local search: each pair that overlaps has a weight that grows while it does, and each
/// shape in turn goes to the best of many places by the weighted sum of its overlaps, whatever
/// stands in the way.
///
/// Source  J. Gardeyn, G. Vanden Berghe, T. Wauters 2025, arXiv 2509.13329: the loss of a pair, its
///         weights and the steps of the search; C. Voudouris, E. Tsang 1999 for the weights as
///         such. Shapes are kept on their sheet here, so that the edge needs no loss.
class Separation
{
public:
    Separation(Board &board, std::uint64_t seed);

    /// Whether nothing overlaps any more. If not, shapes lie as they did when they overlapped
    /// least.
    bool run(const Patience &patience, Meter &meter);
    /// Of all pairs, without weights, as they lie.
    double loss() const;
    /// After shapes were moved by others.
    void look(Meter &meter);

    std::vector<Pose> poses() const;
    void setPoses(const std::vector<Pose> &poses);

    Random &random() { return m_random; }

private:
    struct Candidate
    {
        Pose pose;
        double loss = std::numeric_limits<double>::infinity();
    };

    float &lossOf(std::size_t a, std::size_t b) { return m_losses[a * m_size + b]; }
    float &weightOf(std::size_t a, std::size_t b) { return m_weights[a * m_size + b]; }

    double pairLoss(const Shape &a, const Posed &posedA, std::size_t b, const Vec2 &by,
                    Meter &meter) const;
    double lossAt(std::size_t item, const Posed &posed, const Vec2 &at, double bound,
                  Meter &meter) const;
    void lookAt(std::size_t item, Meter &meter);
    bool overlaps(std::size_t item) const { return m_sums[item] > 0.0; }
    void moveAll(Meter &meter);
    void move(std::size_t item, Meter &meter);
    void sample(std::size_t item, Meter &meter);
    void consider(std::size_t item, const Candidate &candidate);
    const Posed &posedAt(std::size_t item, const Pose &pose);
    std::optional<Candidate> evaluated(std::size_t item, Pose pose, double bound, Meter &meter);
    void descend(std::size_t item, Candidate &candidate, double step, double least, Meter &meter);
    Pose anywhere(std::size_t item);
    Pose nearby(std::size_t item);
    void raiseWeights();

    Board &m_board;
    Random m_random;
    std::size_t m_size;
    std::vector<float> m_losses, m_weights; // of pairs
    std::vector<double> m_sums;             // of each item's losses
    std::vector<Candidate> m_best;          // places of the one that moves
    Posed m_turned;                         // of it, turned freely
};

} // namespace fff::nest

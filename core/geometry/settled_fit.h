// A fit that grows with its line: what lies far enough back is settled, and fitted no more.
#pragma once

#include "core/geometry/fit.h"

#include <vector>

namespace fff {

/// The chain of a line to which samples are added, as fitCurve() would make it of the samples since
/// the last settled joint.
///
/// Where the line stops being open to change follows from the samples alone: once so many of them
/// are beyond what is settled, the segments of the first half of these are. So it does not matter
/// how often, or when, anybody looks. A line of fewer than kWindow samples has nothing settled: its
/// chain is that of fitCurve(). Cost of a sample O(kWindow) where each is looked at, O(1) besides.
class SettledFit
{
public:
    /// Samples beyond the last settled joint before the next is looked for; more of them once none
    /// was found.
    static constexpr std::size_t kWindow = 512;
    static constexpr std::size_t kLargestWindow = 3 * kWindow;

    explicit SettledFit(const FitOptions &options) : m_options(options) {}

    /// Settles what `samples` (all looked at, SampledLine::usable) let be settled, of which the
    /// last may still change. All but that one are those of the call before, and further ones.
    void follow(const std::vector<Vec2> &samples) { follow(samples, samples.size()); }
    /// The same of the first so many of them.
    void follow(const std::vector<Vec2> &samples, std::size_t count);

    /// From the first sample on, each where the one before ends. What is in it never changes.
    const std::vector<FittedPiece> &pieces() const { return m_pieces; }
    /// Samples that cubics were held against to settle them.
    std::size_t work() const { return m_work; }

private:
    void settle(const std::vector<Vec2> &samples, std::size_t end);

    FitOptions m_options;
    std::vector<FittedPiece> m_pieces;
    std::size_t m_next = kWindow; // samples there have to be before something is settled
    std::size_t m_work = 0;
};

/// The chain along `line` with `known` as parts of it; between them and at both ends it is fitted.
/// Of `known`, in order and apart from each other, `from` and `to` are indices into `line` (all
/// looked at).
std::vector<CubicBezier> fitAround(const std::vector<Vec2> &line,
                                   const std::vector<FittedPiece> &known,
                                   const FitOptions &options);

/// Of its chord, mm.
double lengthOf(const FittedPiece &piece);

} // namespace fff

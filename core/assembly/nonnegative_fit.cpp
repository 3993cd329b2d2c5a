#include "core/assembly/nonnegative_fit.h"

#include <Eigen/QR>
#include <vector>

namespace fff {

namespace {

/// Of the target's length, for columns of about unit length: what a column could still bring.
constexpr double kNoGain = 1e-10;

/// The columns that are taken, and how often.
class Fit
{
public:
    Fit(const Eigen::MatrixXd &columns, const Eigen::VectorXd &target)
        : m_columns(columns), m_target(target), m_isTaken(static_cast<std::size_t>(columns.cols())),
          m_rest(target)
    {
    }

    const Eigen::VectorXd &rest()
    {
        const Eigen::Index passes = 3 * m_columns.cols();
        for (Eigen::Index pass = 0; pass < passes; ++pass) {
            const Eigen::Index best = bestColumn();
            if (best < 0)
                break;
            take(best);
        }
        return m_rest;
    }

private:
    /// The one that brings most; −1: none brings anything.
    Eigen::Index bestColumn() const
    {
        const Eigen::VectorXd gains = m_columns.transpose() * m_rest;
        Eigen::Index best = -1;
        double most = kNoGain * m_target.norm();
        for (Eigen::Index i = 0; i < gains.size(); ++i)
            if (m_isTaken[static_cast<std::size_t>(i)] == kNot && gains[i] > most) {
                best = i;
                most = gains[i];
            }
        return best;
    }

    void take(Eigen::Index column)
    {
        m_taken.push_back(column);
        m_times.conservativeResize(m_times.size() + 1);
        m_times[m_times.size() - 1] = 0.0;
        m_isTaken[static_cast<std::size_t>(column)] = kTaken;
        while (!m_taken.empty()) {
            const Eigen::MatrixXd taken = m_columns(Eigen::all, m_taken);
            const Eigen::VectorXd wanted = taken.colPivHouseholderQr().solve(m_target);
            // As far as none becomes negative.
            double share = 1.0;
            for (Eigen::Index i = 0; i < wanted.size(); ++i)
                if (!(wanted[i] > 0.0))
                    share = std::min(share, m_times[i] / (m_times[i] - wanted[i]));
            if (!(share < 1.0)) {
                m_times = wanted;
                break;
            }
            m_times += share * (wanted - m_times);
            if (drop(wanted, column))
                break;
        }
        m_rest = m_target;
        if (!m_taken.empty())
            m_rest -= m_columns(Eigen::all, m_taken) * m_times;
    }

    /// What has come down to zero. True when the one that was just taken is among it: it brings
    /// nothing but by rounding, and is not asked again.
    bool drop(const Eigen::VectorXd &wanted, Eigen::Index column)
    {
        bool isBack = false;
        Eigen::Index kept = 0;
        std::vector<Eigen::Index> taken;
        for (Eigen::Index i = 0; i < m_times.size(); ++i) {
            const Eigen::Index which = m_taken[static_cast<std::size_t>(i)];
            if (!(wanted[i] > 0.0) && !(m_times[i] > kNoGain)) {
                m_isTaken[static_cast<std::size_t>(which)] = which == column ? kUseless : kNot;
                isBack = isBack || which == column;
                continue;
            }
            taken.push_back(which);
            m_times[kept++] = m_times[i];
        }
        m_times.conservativeResize(kept);
        m_taken = std::move(taken);
        return isBack;
    }

    enum State : char { kNot, kTaken, kUseless };

    const Eigen::MatrixXd &m_columns;
    const Eigen::VectorXd &m_target;
    std::vector<char> m_isTaken;
    std::vector<Eigen::Index> m_taken;
    Eigen::VectorXd m_times; // of these
    Eigen::VectorXd m_rest;  // of the target
};

} // namespace

double distanceFromCone(const Eigen::MatrixXd &columns, const Eigen::VectorXd &target)
{
    return Fit(columns, target).rest().norm();
}

Eigen::VectorXd restBeyondCone(const Eigen::MatrixXd &columns, const Eigen::VectorXd &target)
{
    return Fit(columns, target).rest();
}

} // namespace fff

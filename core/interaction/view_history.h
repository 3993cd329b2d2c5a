// The views that were rested at, for "previous view".
#pragma once

#include "core/interaction/camera.h"

#include <deque>
#include <optional>

namespace fff {

class ViewHistory
{
public:
    enum class Change { Turn, Drag, Wheel };

    /// The view is about to leave `from` by such a change. Steps of a wheel that follow each other
    /// are one change: only the first leaves a view behind.
    void leave(const Camera &from, Change change);
    /// Something else was done: the next step of a wheel is a change of its own.
    void interrupt() { m_last.reset(); }
    /// Takes the newest view that looks different from `current` out of the history. None: nothing
    /// to go back to.
    std::optional<Camera> takeBack(const Camera &current);
    bool canGoBack(const Camera &current) const;
    void clear();

    /// The oldest views are forgotten beyond this many.
    static constexpr std::size_t kCapacity = 64;

private:
    std::deque<Camera> m_views; // newest last
    std::optional<Change> m_last;
};

} // namespace fff

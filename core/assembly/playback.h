// Where the parts of a model are while it is put together, step by step, and where they are when
// all of them are drawn apart.
#pragma once

#include "core/assembly/planning.h"
#include "core/geometry/vector.h"

#include <optional>
#include <vector>

namespace fff {

struct PartPlace
{
    Vec3 offset = Vec3::Zero(); // from where it ends up, mm
    bool isThere = false;       // put down, or on its way
    bool isMoving = false;      // of the step that is under way, also when that has just ended
};

/// Plays the steps of a plan. Time is counted in steps: step i goes on from i to i + 1, and at a
/// whole number so many steps are done. The parts of a step begin clear of the others, go along its
/// moves one after the other, and are in their place a little before it ends.
///
/// Parts that are put together before they are brought to the others as one are put together
/// aside: so much further back along the way of that step that they are nowhere among the others.
/// That, and no more, is added to the plan's distances.
class Playback
{
public:
    Playback() = default;
    /// boxes: of the parts in their places, world, mm; the plan's indices. Of a plan that is not
    /// possible there are no steps, and no part is ever there.
    Playback(AssemblyPlan plan, std::vector<Box3> boxes);

    const AssemblyPlan &plan() const { return m_plan; }
    int partCount() const { return static_cast<int>(m_boxes.size()); }
    int stepCount() const { return static_cast<int>(m_plan.steps.size()); }
    /// Which one is under way, or has just ended; −1 at the beginning.
    int stepAt(double time) const;

    /// time      what lies outside of 0 … stepCount() is the nearest of these
    /// drawnApart  0: in their places, 1: every part so far back along its way that its box meets
    ///             none of those it was brought to, which are drawn apart as well
    std::vector<PartPlace> at(double time, double drawnApart = 0.0) const;
    /// As a step begins: its parts are where their way begins.
    std::vector<PartPlace> before(int step, double drawnApart = 0.0) const;

    /// The corners of a step's way, first to last: offsets from where its parts end up, the last
    /// one 0. One corner only for what is put down.
    const std::vector<Vec3> &way(int step) const { return m_ways[static_cast<std::size_t>(step)]; }
    /// The middle of a step's parts where they end up, at that factor.
    Vec3 middleOf(int step, double drawnApart = 0.0) const;
    /// Which direction the last move of a step has; none for what is put down.
    std::optional<Vec3> lastDirection(int step) const;

    /// All that parts ever take up at that factor, world.
    Box3 reach(double drawnApart = 0.0) const;

private:
    std::vector<PartPlace> placesDuring(int step, double share, double drawnApart) const;
    Vec3 asideOf(std::size_t step) const;
    void drawApart(std::size_t step);

    AssemblyPlan m_plan;
    std::vector<Box3> m_boxes;
    std::vector<std::vector<Vec3>> m_ways; // of each step
    std::vector<int> m_first;              // of each part: the step that it comes with
    double m_diagonal = 0.0;               // of the model, mm
    std::vector<Vec3> m_apart;             // of each part: where it is when all are drawn apart
};

} // namespace fff

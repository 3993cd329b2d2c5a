// What is drawn of a model that is being put together: its parts where they are at the time, each a
// section of the scene of its own.
#pragma once

#include "core/interaction/camera.h"
#include "core/session/assembly_steps.h"
#include "ui/view/scene.h"
#include "ui/view/step_marks.h"

#include <vector>

namespace fff::ui {

/// A picture of it: the scene, and what lies over it.
struct StepsPicture
{
    Scene scene;
    StepMarks marks;
};

class StepsScene
{
public:
    explicit StepsScene(AssemblyStepsPointer steps);

    const AssemblySteps &steps() const { return *m_steps; }
    const AssemblyStepsPointer &pointer() const { return m_steps; }

    /// time, drawnApart: as Playback has them. The parts of the step that is under way are
    /// selected, those that come later left out. Numbers are those that are seen from there, not
    /// behind another part.
    StepsPicture at(double time, double drawnApart, const Camera &camera,
                    const Vec2 &viewport) const;
    /// As a step begins.
    StepsPicture before(int step, const Camera &camera, const Vec2 &viewport) const;
    /// The finished model, nothing selected.
    StepsPicture finished(const Camera &camera, const Vec2 &viewport) const;

    /// The same without what lies over them: a place for each number takes time, and a camera.
    Scene sceneAt(double time, double drawnApart) const;
    Scene sceneBefore(int step) const;
    Scene finishedScene() const;

private:
    /// A part in its place, and where its number may stand, the best first (frame coordinates).
    struct Item
    {
        SceneSection section;
        std::vector<Vec2> numberPlaces;
        double extent = 0.0;              // the smaller one, mm
        const RegionTree *tree = nullptr; // of its outline, kept by its cut
    };
    std::vector<PartPlace> finishedPlaces() const;
    Scene sceneOf(const std::vector<PartPlace> &places, double drawnApart) const;
    void addWay(StepsPicture &picture, int step, double drawnApart) const;
    void addNumbers(StepsPicture &picture, const std::vector<PartPlace> &places,
                    const Camera &camera, const Vec2 &viewport) const;
    bool isCovered(const Vec3 &at, std::size_t part, const std::vector<PartPlace> &places,
                   const Vec3 &towardsEye) const;
    /// How much of the part's face round a place of a number is seen, of 5.
    int roomAt(const Vec2 &place, std::size_t part, const std::vector<PartPlace> &places,
               const Camera &camera, const Vec2 &viewport) const;
    /// Of what moves: beside its arrow, and the same all the way.
    Vec2 placeBesideWay(std::size_t part, const std::vector<Vec3> &way, const Camera &camera,
                        const Vec2 &viewport) const;
    Vec3 onFace(const Vec2 &place, std::size_t part, const Vec3 &offset, const Camera &camera,
                const Vec2 &viewport) const;

    AssemblyStepsPointer m_steps;
    std::vector<Item> m_items;       // by the plan's indices
    mutable double m_reachOf = -1.0; // drawnApart that the reach was worked out for
    mutable Box3 m_reach;
};

} // namespace fff::ui

// A scene whose bodies stand where they move, larger than they do.
#pragma once

#include "core/analysis/movement.h"
#include "ui/view/scene.h"

namespace fff::ui {

/// Keeps the bent bodies of the picture before: only another movement makes them anew, and how far
/// it is shown is the graphics card's matter.
class MovedScene
{
public:
    /// A section of its own for each body, which looks as its section in the scene does. Of a scene
    /// of another model than the movement's: the scene as it is.
    /// times  of the movement; 0 is the true place
    const Scene &at(const Scene &scene, const Model &model, const Movement &movement, double times);

private:
    /// Of a body: boxes of where its vertices are and of where they go, world, mm.
    struct Reach
    {
        Box3 flat, way;
    };
    static Reach reachOf(const BentSlab &slab, const Frame &frame, double half);
    void bend(const Movement &movement);

    Scene m_scene;
    std::shared_ptr<const BentModel> m_bent;              // that the slabs are of
    std::vector<std::shared_ptr<const BentSlab>> m_slabs; // of each body; null: moved as it is
    std::vector<Reach> m_reaches;                         // of these
};

} // namespace fff::ui

// A scene whose bodies stand where they move, larger than they do.
#pragma once

#include "core/analysis/movement.h"
#include "ui/view/scene.h"

namespace fff::ui {

/// Keeps the bent bodies of the picture before: only another movement makes them anew.
class MovedScene
{
public:
    /// A section of its own for each body, which looks as its section in the scene does. Of a scene
    /// of another model than the movement's: the scene as it is.
    /// times  of the movement; 0 is the true place
    const Scene &at(const Scene &scene, const Model &model, const Movement &movement, double times);

private:
    void bend(const Movement &movement, double times);

    Scene m_scene;
    std::shared_ptr<const BentModel> m_bent; // that the meshes are of
    double m_times = 0.0;
    std::vector<std::shared_ptr<const SlabMesh>> m_meshes; // of each body; null: moved as it is
};

} // namespace fff::ui

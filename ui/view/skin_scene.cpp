#include "ui/view/skin_scene.h"

namespace fff::ui {

namespace {

constexpr double kSkinOpacity = 0.55;

} // namespace

SceneTemplate sceneSkin(TemplateMeshPointer mesh)
{
    const Box3 bounds = mesh->mesh->bounds();
    return {std::move(mesh), Similarity::moved(bounds.center()), bounds, kSkinOpacity, false, true};
}

} // namespace fff::ui

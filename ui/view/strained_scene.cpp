#include "ui/view/strained_scene.h"

namespace fff::ui {

void showStress(Scene &scene, const Model &model, const BentModel *bent)
{
    for (SceneSection &section : scene.sections)
        section.fields.clear();
    if (!bent || scene.sections.size() != model.sectionCount())
        return;
    const Model &before = bent->analysis->model;
    for (std::size_t i = 0; i < bent->fields.size(); ++i) {
        if (!bent->fields[i])
            continue;
        const auto of =
            static_cast<std::size_t>(bent->analysis->bodies.sectionOf(static_cast<int>(i)));
        const bool isThere = of < model.sectionCount() && model.ref(of) == before.ref(of);
        const int at = isThere ? static_cast<int>(of) : model.indexOf(before.ref(of));
        if (at >= 0)
            scene.sections[static_cast<std::size_t>(at)].fields.push_back(bent->drawn[i]);
    }
}

} // namespace fff::ui

#include "ui/view/scene.h"

namespace fff::ui {

bool SceneSection::operator==(const SceneSection &other) const
{
    return cut == other.cut && shape == other.shape && frame == other.frame &&
           thickness == other.thickness && look.face == other.look.face &&
           isSelected == other.isSelected && isHovered == other.isHovered &&
           isGhost == other.isGhost;
}

void SceneBuilder::setAnalysis(const Analysis &analysis)
{
    m_known.clear();
    const std::size_t count = std::min(analysis.model.sectionCount(), analysis.cuts.size());
    for (std::size_t i = 0; i < count; ++i)
        m_known[analysis.model.ref(i)] = {analysis.model.section(i)->shape,
                                          analysis.model.section(i)->frame, analysis.cuts[i]};
}

Scene SceneBuilder::build(const Model &model) const
{
    Scene scene;
    scene.sections.reserve(model.sectionCount());
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        const Stock &stock = model.stockOf(i);
        SceneSection item;
        item.shape = section.shape;
        item.frame = section.frame;
        item.thickness = stock.thickness;
        item.look = stockLook(stock);
        // A section that is being drawn has a new shape with every move: its last cut stays until
        // the next one is there, or its slits would flicker.
        const auto known = m_known.find(model.ref(i));
        if (known != m_known.end() &&
            (known->second.shape == section.shape || known->second.frame == section.frame))
            item.cut = known->second.cut;
        Box3 box = worldBounds(*section.shape, section.frame);
        const Vec3 reach = 0.5 * stock.thickness * section.frame.normal().cwiseAbs();
        box.min -= reach;
        box.max += reach;
        scene.bounds.extend(box);
        scene.sections.push_back(std::move(item));
    }
    return scene;
}

} // namespace fff::ui

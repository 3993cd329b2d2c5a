// What the renderer draws: the sections of the model that is shown, each with the newest cut that
// is known for it.
#pragma once

#include "core/session/analysis.h"
#include "ui/view/view_style.h"

#include <map>
#include <memory>
#include <vector>

namespace fff::ui {

struct SceneSection
{
    // What its mesh is made of: the cut section, or the bare shape while no cut of it is known.
    CutSectionPointer cut; // may be null
    ShapePointer shape;
    Frame frame;
    double thickness = 3.0; // mm
    StockLook look;
    bool isSelected = false, isHovered = false;
    bool isGhost = false; // stands back while another one is drawn

    const void *meshKey() const
    {
        return cut ? static_cast<const void *>(cut.get()) : static_cast<const void *>(shape.get());
    }
    bool operator==(const SceneSection &other) const;
};

struct Scene
{
    std::vector<SceneSection> sections;
    Box3 bounds; // of the slabs, mm
};

/// Remembers the last cut of every section, so that nothing flickers while a newer analysis is on
/// its way: its model may be older than the one that is shown, so sections are found by what they
/// are, never by their index.
class SceneBuilder
{
public:
    void setAnalysis(const Analysis &analysis);
    Scene build(const Model &model) const;

private:
    struct Known
    {
        ShapePointer shape;
        Frame frame;
        CutSectionPointer cut;
    };
    std::map<SectionRef, Known> m_known;
};

} // namespace fff::ui

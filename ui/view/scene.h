// What the renderer draws: the sections of the model that is shown, each with the newest cut that
// is known for it.
#pragma once

#include "core/analysis/analysis.h"
#include "core/interaction/view_state.h"
#include "core/physics/stress_field.h"
#include "ui/view/flat_painter.h"
#include "ui/view/slit_covers.h"
#include "ui/view/template_painter.h"
#include "ui/view/thing.h"
#include "ui/view/view_style.h"

#include <memory>
#include <span>
#include <vector>

namespace fff::ui {

using CoversPointer = std::shared_ptr<const std::vector<SlitCover>>;

struct BentSlab;
struct SlabMesh;

struct SceneSection
{
    // What its mesh is made of: the cut section, or the bare shape while no cut of it is known.
    CutSectionPointer cut; // may be null
    ShapePointer shape;
    std::shared_ptr<const BentSlab> bent = {}; // in place of that
    double bentTimes = 0.0;                    // as far as it really is
    std::vector<MarkPointer> marks;
    Frame frame;
    double thickness = 3.0; // mm
    StockLook look;
    CoversPointer covers;    // of the cut's slits, shared by those that look alike; may be null
    std::vector<int> guests; // of each cover: its section in the scene, -1 for one that went
    Box3 bounds;             // of the slab, mm
    std::vector<StressFieldPointer> fields = {}; // drawn on its faces, of its bodies
    bool isSelected = false, isHovered = false;
    bool isSibling = false; // of the one that is hovered: the same operation made it
    bool isMade = false;    // by the operation that is selected
    bool isGhost = false;   // stands back while another one is drawn or looked at
    bool isHidden = false;
    bool isProblem = false;  // red and hatched
    bool isFaulty = false;   // outlined in red, without the hatch
    bool isDoubtful = false; // either of them in amber

    /// But for the outlines of what is selected and hovered.
    bool looksTheSame(const SceneSection &other) const;
};

/// Of a region each; none where they could not be worked out: then what is seen are the walls.
std::span<const Triangulation> trianglesOf(const Shape &shape);
std::span<const Triangulation> trianglesOf(const CutSection &cut);

/// The arrays that are uploaded for it: of its cut with its covers, else of its shape.
SlabMesh meshOf(const SceneSection &section);

struct Scene
{
    std::vector<SceneSection> sections;
    std::vector<SceneThing> things;       // what weights stand for
    std::vector<SceneTemplate> templates; // meshes that are seen
    std::vector<SceneFlat> flats;         // pictures and drawings
    Box3 bounds;                          // of the slabs, mm

    /// Of those and the meshes.
    Box3 allBounds() const;
};

/// Remembers the last cut of every section, so that nothing flickers while a newer analysis is on
/// its way: its model may be older than the one that is shown, so sections are found by what they
/// are, never by their index.
class SceneBuilder
{
public:
    void setAnalysis(AnalysisPointer newest);
    /// What magnets make of templates; may be null.
    void setPulled(std::shared_ptr<const PulledTemplates> newest) { m_pulled = std::move(newest); }
    Scene build(const Model &model) const;

private:
    /// Of a section's covers.
    struct Guests
    {
        std::vector<SectionRef> sections;
        std::vector<int> at; // in the model of the analysis
    };
    using GuestsPointer = std::shared_ptr<const Guests>;
    struct Known
    {
        ShapePointer shape;
        Frame frame;
        CutSectionPointer cut;
        CoversPointer covers;
        GuestsPointer guests;
    };
    static GuestsPointer guestsAt(const Model &model, std::vector<int> at);
    const Known *knownOf(const Model &model, std::size_t index) const;
    bool isAsBefore(const Analysis &analysis, std::size_t index) const;
    bool hasSameSections(const Analysis &analysis) const;
    using KnownPointer = std::shared_ptr<const Known>;
    class SharedCovers;

    AnalysisPointer m_analysis = std::make_shared<const Analysis>(); // the newest
    std::shared_ptr<const PulledTemplates> m_pulled;
    std::vector<KnownPointer> m_known; // in the order of its sections
};

/// Hides, ghosts and reddens the sections as the view's state says. The scene is of this model.
void applyView(Scene &scene, const Model &model, const ViewState &view);

} // namespace fff::ui

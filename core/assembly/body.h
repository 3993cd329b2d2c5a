// The pieces that a model is cut into, each as a body: what checks, planning, playback, parts,
// files and mechanics speak of. One list for all of them.
#pragma once

#include "core/assembly/cut_section.h"
#include "core/assembly/mass.h"
#include "core/assembly/slab.h"
#include "core/assembly/solid.h"
#include "core/assembly/stability.h"
#include "core/base/once.h"
#include "core/model/model.h"

#include <memory>
#include <span>
#include <vector>

namespace fff {

/// What a piece is called. Survives edits: pieces are counted along the section's contour, by the
/// first of its points that they have, so that a slit which is cut deeper, or turned round, calls
/// no piece by another one's name. Pieces without such a point come last, the largest first.
struct BodyKey
{
    SectionRef section;
    int piece = 0;

    auto operator<=>(const BodyKey &) const = default;
};

/// One piece of a section as it is cut, in its place. Immutable, and the same object for as long as
/// nothing of it changes. What takes work is worked out when it is first asked for, once, from any
/// thread.
class Body
{
public:
    /// piece    index in the cut's parts
    /// density  kg/m³
    Body(BodyKey key, CutSectionPointer cut, std::size_t piece, const Frame &frame,
         double thickness, double density);

    const BodyKey &key() const { return m_key; }
    const CutSectionPointer &cut() const { return m_cut; }
    std::size_t piece() const { return m_piece; }
    const Frame &frame() const { return m_frame; }
    double thickness() const { return m_thickness; } // mm
    /// Contour − holes − slits, clearance included, kerf not; frame coordinates, mm.
    const CurvedRegion &outline() const { return m_cut->parts()[m_piece]; }
    /// Refers to this body.
    Slab slab() const { return {outline().region, m_frame, m_thickness}; }
    /// World, mm.
    const Box3 &box() const;
    /// Exact area × thickness × density. Weights that hang on it are not in it.
    const MassProperties &mass() const;
    const GroundContact &contact() const;
    /// What of it can come to touch the ground (settling.h).
    const std::vector<Vec3> &undermost() const;
    /// Errors  NotCutOut, NotSolid; the names of sections are for those who know them.
    const Result<SolidPointer> &solid() const;

    /// Whether it is what these would make.
    bool isOf(const SectionRef &section, const CutSectionPointer &cut, const Frame &frame,
              double thickness, double density) const;

private:
    BodyKey m_key;
    CutSectionPointer m_cut;
    std::size_t m_piece;
    Frame m_frame;
    double m_thickness, m_density;
    mutable Once m_boxOnce, m_massOnce, m_contactOnce, m_undermostOnce, m_solidOnce;
    mutable Box3 m_box;
    mutable MassProperties m_mass;
    mutable GroundContact m_contact;
    mutable std::vector<Vec3> m_undermost;
    mutable Result<SolidPointer> m_solid;
};

using BodyPointer = std::shared_ptr<const Body>;

/// All bodies of a model by its sections, larger ones of a section first. Kept in runs of sections,
/// which the lists of two models share where nothing in them differs.
class Bodies
{
public:
    std::size_t size() const { return m_all.size(); }
    const Body &operator[](std::size_t index) const { return **m_all[index]; }
    const Body &at(int index) const { return **m_all[static_cast<std::size_t>(index)]; }
    const BodyPointer &pointer(int index) const { return *m_all[static_cast<std::size_t>(index)]; }

    /// Of `const Body &`.
    class Iterator;
    Iterator begin() const;
    Iterator end() const;

    std::size_t sectionCount() const { return m_first.size() - 1; }
    /// The index in the model of the section that a body is of.
    int sectionOf(int body) const { return m_sections[static_cast<std::size_t>(body)]; }
    /// The bodies of a section, and the place of the first of them in the list.
    std::span<const BodyPointer> of(int section) const;
    int firstOf(int section) const { return m_first[static_cast<std::size_t>(section)]; }
    int countOf(int section) const { return firstOf(section + 1) - firstOf(section); }

    /// Of a section: the box, world, mm, and the mass of all its bodies.
    Box3 boxOf(int section) const;
    MassProperties massOf(int section) const;
    /// Of all of them.
    MassProperties mass() const;

private:
    friend class BodyLister;

    struct Run;
    using RunPointer = std::shared_ptr<const Run>;

    std::vector<std::shared_ptr<const Stock>> m_stocks; // of the model
    CutList m_cuts;                                     // that they are of
    std::vector<RunPointer> m_runs;                     // one a block of these
    std::vector<const BodyPointer *> m_all;             // in the runs
    std::vector<int> m_sections;
    std::vector<int> m_first{0}; // of each section, and behind the last one their number
};

class Bodies::Iterator
{
public:
    using value_type = Body;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    using pointer = const Body *;
    using reference = const Body &;

    Iterator() = default;
    explicit Iterator(const BodyPointer *const *at) : m_at(at) {}
    reference operator*() const { return ***m_at; }
    pointer operator->() const { return (*m_at)->get(); }
    Iterator &operator++()
    {
        ++m_at;
        return *this;
    }
    Iterator operator++(int)
    {
        Iterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Iterator &) const = default;

private:
    const BodyPointer *const *m_at = nullptr;
};

inline Bodies::Iterator Bodies::begin() const
{
    return Iterator(m_all.data());
}
inline Bodies::Iterator Bodies::end() const
{
    return Iterator(m_all.data() + m_all.size());
}

/// cuts    belong to the model, one a section
/// before  of another model: bodies that are the same stay the same objects
/// places  of the model's sections in that other one, as placesBefore() has them
Bodies bodiesOf(const Model &model, const CutList &cuts, const Bodies &before = {},
                const std::optional<std::vector<int>> &places = std::nullopt);

} // namespace fff

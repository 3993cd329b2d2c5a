// A section with its slits cut: what is drawn in the view and what is sent to the machine.
#pragma once

#include "core/assembly/joint.h"
#include "core/assembly/shared_list.h"
#include "core/base/once.h"
#include "core/geometry/boolean.h"
#include "core/geometry/notch.h"
#include "core/geometry/region_tree.h"
#include "core/model/shape.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace fff {

/// What a slit cuts, whatever joint it belongs to.
struct SlitKey
{
    std::array<double, 5> rectangle{};
    bool isOpen = true; // of no account without a form
    SlitRole role = SlitRole::Slit;
    std::shared_ptr<const SlitForm> form;

    bool operator==(const SlitKey &other) const
    {
        return rectangle == other.rectangle && isOpen == other.isOpen && role == other.role &&
               (form == other.form || (form && other.form && *form == *other.form));
    }
};

/// What slits leave of a shape, and the tabs among them: connected pieces, largest first.
/// chord, errors: see subtractContours().
Result<std::vector<CurvedRegion>> cutShape(const Shape &shape, const std::vector<Slit> &slits,
                                           double chord);

struct SlitNotch
{
    SlitKey slit;
    NotchPointer notch;
};

/// Immutable; shared for as long as shape and slits stay the same, so its address tells what to
/// redraw.
class CutSection
{
public:
    /// Of parts that were cut elsewhere.
    explicit CutSection(std::vector<CurvedRegion> parts);
    /// before   null, or of the same shape: what was found for slits that are still the same is
    ///          not looked for again
    CutSection(const Shape &shape, const std::vector<Slit> &slits, const CutSection *before);

    /// Why it could not be cut out; mostly nothing. Its one part is then the shape without its
    /// slits: something to see and to weigh, but nothing to cut (core/fabrication/wholeness.h).
    const std::optional<Error> &failure() const { return m_failure; }
    /// Connected pieces of contour − holes − slits + tabs, largest first; usually one. Without
    /// chips below kWasteArea, unless there is nothing else. Frame coordinates, mm.
    const std::vector<CurvedRegion> &parts() const { return m_parts; }
    /// Where those chips are: a point of each.
    const std::vector<Vec2> &waste() const { return m_waste; }
    /// Of each part's region, computed at first use, once, from any thread. Errors  as
    /// triangulate().
    const Result<std::vector<Triangulation>> &triangulations() const;
    /// Of each part's region, the same way.
    const std::vector<RegionTree> &trees() const;
    double area() const;
    /// Of all parts together, exact for the curves. Computed at first use, as the triangles.
    const Moments &moments() const;
    /// The parts, each grown by half the kerf (core/geometry/offset.h), in the same order, or why
    /// one cannot be. Kept for the kerf that was asked for last; from any thread. kerf   above 0,
    /// mm
    using Paths = std::shared_ptr<const std::vector<CurvedRegion>>;
    Result<Paths> compensated(double kerf) const;

    /// What it takes by now, with all that was worked out of it; from any thread.
    std::size_t bytes() const;

private:
    void sortOutWaste();

    std::vector<CurvedRegion> m_parts;
    std::vector<Vec2> m_waste;
    std::vector<SlitNotch> m_notches; // of all slits, or empty
    mutable std::mutex m_compensatedMutex;
    mutable double m_compensatedKerf = 0.0;
    mutable Result<Paths> m_compensated; // null: not asked for yet
    mutable std::atomic<std::size_t> m_triangleBytes = 0, m_treeBytes = 0, m_compensatedBytes = 0;
    mutable Once m_once, m_treesOnce, m_momentsOnce;
    mutable Moments m_moments;
    mutable Result<std::vector<Triangulation>> m_triangulations;
    mutable std::vector<RegionTree> m_trees;
    std::optional<Error> m_failure;
};

using CutSectionPointer = std::shared_ptr<const CutSection>;
/// Of all sections of a model.
using CutList = SharedList<CutSectionPointer>;

/// Keeps cut sections by (Shape, slits). Holds shapes weakly, and no cuts of shapes that are gone;
/// bounded in bytes (least recently used goes first). Not for several threads at once.
class CutCache
{
public:
    /// Of the cuts, with all that was worked out of them.
    static constexpr std::size_t kRoom = 64u << 20; // bytes

    explicit CutCache(std::size_t room = kRoom);
    ~CutCache();
    CutCache(CutCache &&) noexcept;
    CutCache &operator=(CutCache &&) noexcept;

    /// Leaves what there is room for. Is done now and then by itself; here for who has worked much
    /// out of the cuts.
    /// sections   of the model: the cuts of twice as many are kept, if they fit
    void trim(std::size_t sections);

    struct Data;
    Data &data() { return *m_data; }

private:
    std::unique_ptr<Data> m_data;
};

/// The shape with its slits cut, on chords of kCutChord. From the cache when it has been asked for
/// before, else from `before` as far as it goes: null, or a cut of the same shape.
CutSectionPointer cutSection(const ShapePointer &shape, const std::vector<Slit> &slits,
                             CutCache &cache, const CutSection *before = nullptr);

} // namespace fff

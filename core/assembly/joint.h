// Where sections meet and what each of them is cut by. All of it is derived from a Model; nothing
// is saved.
#pragma once

#include "core/assembly/shared_rows.h"
#include "core/assembly/slit_form.h"
#include "core/geometry/polygon.h"
#include "core/model/model.h"

#include <memory>
#include <span>
#include <vector>

namespace fff {

/// The intersection line of two mid-planes, in the world. `direction` is a unit vector; distances
/// along the axis (mm) are counted from `point`.
struct Axis
{
    Vec3 point = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();

    Vec3 at(double s) const { return point + s * direction; }
};

/// Where an axis crosses the boundary of a section: `edge` of the shape's region() from vertex
/// `edge` to the next one, of the contour (ring 0) or of hole ring − 1.
struct AxisEnd
{
    double at = 0.0; // mm along the axis
    int ring = 0;
    int edge = 0;

    bool isOnHole() const { return ring > 0; }
};

/// A stretch of an axis inside a section.
struct Interval
{
    AxisEnd from, to; // from.at < to.at

    double length() const { return to.at - from.at; }
};

/// A stretch of an axis inside both sections, and the interval of each that it is part of.
struct Overlap
{
    double from = 0.0, to = 0.0;
    double meet = 0.0; // where its two slits meet: in the middle, unless an end lies on a hole
    Interval a, b;
};

/// What two placed shapes share. Where slits meet is their joint's; all else depends on both
/// (Shape, Frame) and on nothing else.
struct Crossing
{
    Axis axis;
    double angle = 0.0;            // between the planes, 0 … π/2
    std::vector<Overlap> overlaps; // along the axis
};

/// What a cut is for.
enum class SlitRole {
    Slit,     // holds the other section
    Shoulder, // where a section ends on the other's face: all that would be in the other
    Tab       // is not cut but added: it reaches through a slot in the other
};

/// The cut that one section (host) makes for one overlap: a rectangle along the axis, in the host's
/// frame coordinates, and what its form adds.
struct Slit
{
    Vec2 inner = Vec2::Zero(); // middle of its bottom: the meeting point
    Vec2 mouth =
        Vec2::Zero();   // middle of its open end, beyond the contour; of a mortise the other end
    double width = 0.0; // mm
    bool isOpen = true; // false: a mortise, a shoulder (along the axis), a tab (inner: its root)
    SlitRole role = SlitRole::Slit;
    int joint = 0;   // Joint::id
    int overlap = 0; // index into the joint's overlaps; −1: the slabs meet beside the axis
    int guest = 0;   // index of the other section in the Model
    std::shared_ptr<const SlitForm> form; // null: the plain rectangle

    /// The rectangle's four corners, counter-clockwise: what is cut without a form.
    Polygon outline() const;
    /// What is cut, as contours that may overlap each other, counter-clockwise: mostly one, of a
    /// tab none.
    std::vector<Contour> cuts() const;
    /// The same as chords within `chord` mm of the curves; of a tab what is added.
    std::vector<Polygon> outlines(double chord) const;
    /// The middle of its end: the meeting point, or as far beyond it as an arc reaches.
    Vec2 bottom() const;
    bool operator==(const Slit &other) const;
};

struct Joint
{
    int id = 0;       // 1 … n in the order of the model's sections; engraved on both mates
    int a = 0, b = 0; // indices of the sections in the Model, a < b
    JointKind kind = JointKind::CrossLap;
    std::shared_ptr<const Crossing> crossing;
};

/// Those of one joint (its id), among all of a section, which stand in the order of the joints.
std::span<const Slit> slitsOfJoint(const std::vector<Slit> &slits, int joint);

/// Whether the sections come apart along the joint's axis; of a mortise and of tabs one of them
/// comes out of the other square to it, in its own plane.
inline bool slidesAlongAxis(JointKind kind)
{
    return kind == JointKind::CrossLap || kind == JointKind::ExtendedCrossLap;
}

/// The joints of a model in the order of their ids, which is that of (a, b). Kept by their first
/// section, so that an edit replaces the rows of a few sections and copies share all others.
class JointList
{
public:
    std::size_t size() const { return m_starts.empty() ? 0 : m_starts.back(); }
    bool empty() const { return size() == 0; }
    /// By the joint's id − 1. O(log sections).
    const Joint &operator[](std::size_t index) const;
    const Joint &at(std::size_t index) const;
    const Joint &front() const { return (*this)[0]; }
    const Joint &back() const { return (*this)[size() - 1]; }

    /// Of each section the joints in which it is a.
    const SharedRows<Joint> &rows() const { return m_rows; }
    /// How many joints come before those of the row.
    std::size_t start(std::size_t row) const { return m_starts[row]; }
    /// The joint of two sections, a < b, or null.
    const Joint *find(int a, int b) const;

    /// Of the section at the index, in place of its row.
    struct NewRow
    {
        std::size_t index = 0;
        std::vector<Joint> joints; // those without an id come with 0
    };
    /// Takes other rows, in the order of their indices, and gives all joints ids; there are then
    /// `count` rows. Whether a joint that had an id has another one now.
    bool replace(std::size_t count, std::vector<NewRow> rows);

    class Iterator
    {
    public:
        using value_type = Joint;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const Joint *;
        using reference = const Joint &;

        Iterator() = default;
        Iterator(const SharedRows<Joint> *rows, std::size_t row) : m_rows(rows), m_row(row)
        {
            skipEmpty();
        }
        reference operator*() const { return (*m_rows)[m_row][m_index]; }
        pointer operator->() const { return &**this; }
        Iterator &operator++()
        {
            if (++m_index == (*m_rows)[m_row].size()) {
                ++m_row;
                skipEmpty();
            }
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
        void skipEmpty()
        {
            m_index = 0;
            while (m_row < m_rows->size() && (*m_rows)[m_row].empty())
                ++m_row;
        }

        const SharedRows<Joint> *m_rows = nullptr;
        std::size_t m_row = 0, m_index = 0;
    };
    Iterator begin() const { return {&m_rows, 0}; }
    Iterator end() const { return {&m_rows, m_rows.size()}; }

private:
    SharedRows<Joint> m_rows;
    std::vector<std::size_t> m_starts; // one a row and the number of all
};

/// All joints of a model and the slits of each of its sections.
struct Assembly
{
    JointList joints;
    SharedRows<Slit> slits;  // one list a section of the model, in the joints' order
    std::vector<Box3> boxes; // of each section, by which neighbours are found
};

} // namespace fff

// Which control points of a section are selected.
#pragma once

#include "core/model/document.h"
#include "core/model/point_edits.h"

#include <vector>

namespace fff {

class PointSelection
{
public:
    SectionId section() const { return m_section; }
    /// Sorted, each once.
    const std::vector<PointAddress> &points() const { return m_points; }
    bool isEmpty() const { return m_points.empty(); }
    bool has(const PointAddress &point) const;

    void select(const Section &section, std::vector<PointAddress> points);
    /// Adds the point, or takes it out when it is selected.
    void toggle(const Section &section, const PointAddress &point);
    void clear();

    /// The section became another one (undo, an edit elsewhere): where as many points are left,
    /// those at the same addresses are selected, else those at the same places.
    void follow(const Document &document);

private:
    SectionId m_section;
    ShapePointer m_shape; // that the addresses belong to
    std::vector<PointAddress> m_points;
};

} // namespace fff

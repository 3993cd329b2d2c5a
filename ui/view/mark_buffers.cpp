#include "ui/view/mark_buffers.h"

#include "core/base/tolerances.h"
#include "core/geometry/line_clip.h"

namespace fff::ui {

namespace {

constexpr PackedNormal kUpwards{0, 0, 127, 127};

std::array<float, 3> onTop(const Vec2 &p)
{
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), 1.0f};
}

void addEdges(const Polygon &line, std::vector<SlabEdge> &edges)
{
    for (std::size_t i = 1; i < line.size(); ++i)
        edges.push_back({onTop(line[i - 1]), onTop(line[i]), kUpwards, kUpwards});
}

} // namespace

std::vector<SlabEdge> markEdges(const SceneSection &section, const Mark &mark)
{
    std::vector<SlabEdge> edges;
    std::vector<const Region *> regions;
    if (section.cut)
        for (const CurvedRegion &part : section.cut->parts())
            regions.push_back(&part.region);
    else
        regions.push_back(&section.shape->region());
    for (const CurvePath &path : mark.paths) {
        const Polygon line = path.flatten(kDrawChord);
        for (const Region *region : regions) {
            const auto pieces = clippedLine(line, *region);
            if (!pieces) // then it is drawn as it is
                addEdges(line, edges);
            else
                for (const Polygon &piece : *pieces)
                    addEdges(piece, edges);
        }
    }
    return edges;
}

MarkBuffers::~MarkBuffers()
{
    for (const auto &[key, entry] : m_entries)
        free(entry);
}

void MarkBuffers::update(const Scene &scene)
{
    for (auto &[key, entry] : m_entries)
        entry.isUsed = false;
    m_ofSection.assign(scene.sections.size(), {});
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        const SceneSection &section = scene.sections[i];
        const void *ground = section.cut ? static_cast<const void *>(section.cut.get())
                                         : static_cast<const void *>(section.shape.get());
        for (const MarkPointer &mark : section.marks) {
            const Key key(ground, mark);
            auto found = m_entries.find(key);
            if (found == m_entries.end())
                found = m_entries.emplace(key, upload(section, *mark)).first;
            found->second.isUsed = true;
            m_ofSection[i].push_back(&found->second.lines);
        }
    }
    for (auto it = m_entries.begin(); it != m_entries.end();) {
        if (it->second.isUsed) {
            ++it;
        } else {
            free(it->second);
            it = m_entries.erase(it);
        }
    }
}

MarkBuffers::Entry MarkBuffers::upload(const SceneSection &section, const Mark &mark)
{
    Entry entry{{mark.kind, makeEdgeArray(m_gl)}, section.cut, section.shape};
    fillEdgeArray(m_gl, entry.lines.edges, markEdges(section, mark), GL_STATIC_DRAW);
    return entry;
}

void MarkBuffers::free(const Entry &entry)
{
    freeEdgeArray(m_gl, entry.lines.edges);
}

} // namespace fff::ui

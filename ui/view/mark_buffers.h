// What is drawn on sections (core/model/mark.h) as lines on the graphics card, as far as there is
// material below it.
#pragma once

#include "ui/view/edge_array.h"
#include "ui/view/scene.h"

#include <map>
#include <utility>

namespace fff::ui {

class MarkBuffers
{
public:
    struct Lines
    {
        Mark::Kind kind = Mark::Kind::Engraved;
        EdgeArray edges;
    };

    explicit MarkBuffers(Gl &gl) : m_gl(gl) {}
    ~MarkBuffers(); // context current
    MarkBuffers(const MarkBuffers &) = delete;
    MarkBuffers &operator=(const MarkBuffers &) = delete;

    /// Uploads what is new in the scene and frees what is no longer in it.
    void update(const Scene &scene);
    /// One for each of its marks.
    const std::vector<const Lines *> &lines(std::size_t section) const
    {
        return m_ofSection[section];
    }

private:
    /// What it is made of; the address is kept alive beside it. A mark by itself: one that is being
    /// drawn costs nothing of those that are there.
    using Key = std::pair<const void *, MarkPointer>; // cut or shape, mark
    struct Entry
    {
        Lines lines;
        CutSectionPointer cut;
        ShapePointer shape;
        bool isUsed = false;
    };
    Entry upload(const SceneSection &section, const Mark &mark);
    void free(const Entry &entry);

    Gl &m_gl;
    std::map<Key, Entry> m_entries;
    std::vector<std::vector<const Lines *>> m_ofSection;
};

/// The lines of a mark on what is left of a section. Knows no OpenGL.
std::vector<SlabEdge> markEdges(const SceneSection &section, const Mark &mark);

} // namespace fff::ui

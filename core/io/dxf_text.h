// The frame of a DXF file: what stands round its entities. Internal to io.
#pragma once

#include "core/geometry/vector.h"
#include "core/io/drawing_text.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fff::io {

enum class DxfVersion {
    R2000, // AC1015
    R12    // AC1009
};

struct DxfLayer
{
    std::string_view name;
    int colour = 7; // of AutoCAD's index
};

/// Source  Autodesk, DXF Reference for AutoCAD 2000 (AC1015) and 12 (AC1009): the sections that a
/// reader insists on, and nothing more.
class DxfText
{
public:
    /// comments  lines of ASCII
    DxfText(DxfVersion version, std::span<const std::string> comments, const Box2 &extents,
            std::span<const DxfLayer> layers, std::size_t length);

    DxfVersion version() const { return m_version; }

    // Of the entity that is written: group code and value.
    void group(int code, std::string_view value);
    void group(int code, int value);
    void group(int code, double value);
    /// Begins an entity on a layer.
    /// subclass  behind AcDbEntity, where the version has such; empty: none
    void entity(std::string_view type, std::string_view layer, std::string_view subclass);

    /// All of it.
    std::string take();

private:
    bool isNew() const { return m_version == DxfVersion::R2000; }
    /// A handle that nothing else has.
    void handle();
    /// The next one, or one that others know.
    void handle(std::uint32_t known);
    void owner(std::uint32_t handle);
    void subclass(std::string_view name);
    void header(const Box2 &extents);
    void table(std::string_view name, std::uint32_t known, int count);
    void record(std::string_view type, std::uint32_t table, std::string_view subclass,
                std::string_view name);
    void lineTypes();
    void layers(std::span<const DxfLayer> layers);
    void otherTables();
    void blocks();
    void objects();

    DxfVersion m_version;
    DrawingText m_out;
    std::uint32_t m_next = 0x100; // handle; those below are named
};

} // namespace fff::io

// What a PLY file says of itself before its data. Internal to io.
#pragma once

#include "core/io/mesh_builder.h"

#include <string>
#include <vector>

namespace fff::io {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };
std::size_t sizeOfPly(PlyType type);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::Float;
    bool isList = false;
    PlyType countType = PlyType::UInt8; // of a list
};

struct PlyElement
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties = {};

    /// Of a property; −1: there is none.
    int find(std::string_view property) const;
    /// That one of it takes at the least, in bytes.
    std::size_t leastBytes(bool isText) const;
};

struct PlyHeader
{
    enum class Format { Text, LittleEndian, BigEndian };
    Format format = Format::Text;
    std::vector<PlyElement> elements;
    std::size_t end = 0;   // where the data begin, in bytes
    std::size_t lines = 0; // of the header
};

/// Errors go to the builder. Source  G. Turk 1994, The PLY Polygon File Format.
PlyHeader readPlyHeader(std::string_view bytes, MeshBuilder &builder);

} // namespace fff::io

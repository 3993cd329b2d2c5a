// Numbers of a glTF file, wherever it keeps them. Internal to io.
#pragma once

#include "core/io/json_cursor.h"
#include "core/io/mesh_builder.h"

#include <map>

namespace fff::io {

/// The buffers of a file: behind its JSON, in it as base64, or beside it.
class GltfBuffers
{
public:
    /// binary: the chunk behind the JSON of a .glb; empty: there is none.
    GltfBuffers(const JsonCursor &root, std::string_view binary, const MeshOptions &options)
        : m_accessors(root.member("accessors")), m_views(root.member("bufferViews")),
          m_bufferList(root.member("buffers")), m_binary(binary), m_options(options)
    {
    }

    /// Rows of `columns` numbers of an accessor, one after the other. Errors go to the cursor's
    /// problems, or to `error` for what is beside the file.
    std::vector<double> numbers(std::int64_t accessor, int columns, std::optional<Error> &error);

private:
    std::string_view bytes(const JsonCursor &view, std::optional<Error> &error);

    /// A list, and its items once one was asked for.
    struct List
    {
        explicit List(const JsonCursor &list) : cursor(list) {}
        JsonCursor cursor;
        std::optional<std::vector<JsonCursor>> items;
        /// Null, and an error, where there is none.
        const JsonCursor *at(std::int64_t index);
    };

    List m_accessors, m_views, m_bufferList;
    std::string_view m_binary;
    const MeshOptions &m_options;
    std::map<std::int64_t, std::string> m_buffers; // that were asked for
};

} // namespace fff::io

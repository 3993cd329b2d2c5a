#include "core/io/mesh_formats.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtCore/QStringList>

#include <algorithm>

namespace fff::io {

namespace {

const std::vector<const MeshFormat *> &meshTable()
{
    static const std::vector<const MeshFormat *> formats = {
        &stlMeshFormat(), &objMeshFormat(),     &plyMeshFormat(),
        &offMeshFormat(), &threeMfMeshFormat(), &gltfMeshFormat(),
    };
    return formats;
}

} // namespace

std::span<const MeshFormat *const> meshFormats()
{
    return meshTable();
}

Result<const MeshFormat *> meshFormatOf(std::string_view head, const std::string &name)
{
    constexpr const char *kAMesh = QT_TRANSLATE_NOOP("Error", "a mesh");
    if (head.empty())
        return failure(ErrorCode::Truncated, placeIn(name, "1"), {kAMesh});
    for (const MeshFormat *format : meshTable())
        if (format->recognises(head))
            return format;
    const QString suffix = QFileInfo(QString::fromStdString(name)).suffix();
    for (const MeshFormat *format : meshTable())
        for (const char *one : format->suffixes)
            if (suffix.compare(QLatin1String(one), Qt::CaseInsensitive) == 0)
                return format;
    return failure(ErrorCode::BadSyntax, placeIn(name, "1"),
                   {quoted(head.substr(0, head.find('\n'))), kAMesh});
}

QString meshPatterns()
{
    QStringList patterns;
    for (const MeshFormat *format : meshTable())
        for (const char *suffix : format->suffixes)
            patterns += QStringLiteral("*.") + QLatin1String(suffix);
    return patterns.join(u' ');
}

} // namespace fff::io

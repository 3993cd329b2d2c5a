// Meshes as files, for verbs that read them.
#pragma once

#include "core/templates/mended_mesh.h"

#include <QFile>
#include <QString>

namespace fff::test {

/// Writes an OBJ file. Its path; empty where it cannot be written.
inline QString putMesh(const QString &path, const MeshDraft &draft)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return {};
    for (const Vec3 &p : draft.positions)
        file.write(QStringLiteral("v %1 %2 %3\n")
                       .arg(p.x(), 0, 'g', 17)
                       .arg(p.y(), 0, 'g', 17)
                       .arg(p.z(), 0, 'g', 17)
                       .toLatin1());
    for (const Triangle &t : draft.triangles)
        file.write(
            QStringLiteral("f %1 %2 %3\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toLatin1());
    return path;
}

} // namespace fff::test

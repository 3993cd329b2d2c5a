#include "ui/files/given_files.h"

#include "core/io/formats.h"
#include "ui/files/mesh_import.h"

namespace fff::ui {

GivenFiles givenFiles(const QStringList &paths)
{
    GivenFiles given;
    for (const QString &path : paths) {
        if (io::formatRead(path, &io::Format::readsDrawings))
            given.drawings += path;
        else if (isMeshFile(path))
            given.meshes += path;
        else
            given.models += path;
    }
    return given;
}

} // namespace fff::ui

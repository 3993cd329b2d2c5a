#include "core/io/own_libraries.h"

#include "core/io/document_file.h"
#include "core/io/machine_library.h"
#include "core/io/material_library.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>

#include <utility>

namespace fff::io {

namespace {

template <class Read, class Add>
void addOwn(const QString &path, const Read &read, const Add &add, std::vector<Error> &errors)
{
    if (!QFileInfo::exists(path))
        return;
    auto own = readFile(path).and_then(
        [&](const std::string &bytes) { return read(bytes, path.toStdString()); });
    if (own)
        add(*std::move(own));
    else
        errors.push_back(std::move(own.error()));
}

} // namespace

std::vector<Error> addOwnLibraries(const QString &folder)
{
    std::vector<Error> errors;
    const QDir there(folder);
    addOwn(there.filePath(QStringLiteral("machines.json")), readMachines, addOwnMachines, errors);
    addOwn(there.filePath(QStringLiteral("materials.json")), readMaterials, addOwnMaterials,
           errors);
    return errors;
}

} // namespace fff::io
